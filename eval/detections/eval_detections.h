// SPDX-License-Identifier: BSD-3-Clause
// The detections of sequences in `armature eval`: no run is needed.
#pragma once

#include <filesystem>
#include <vector>

#include "category/category_model.h"
#include "eval/evaluation.h"

namespace armature {

inline constexpr const char* kDetectionTableName = "detections";

// Two tables a sequence folder and their records. `file`: detections in place of the folder's own
// detections.csv, of one sequence alone; empty: none. Throws InputError: a folder that is no sequence with
// ground truth, a malformed file.
Evaluation MakeDetectionTables(const std::vector<std::filesystem::path>& sequences,
                               const std::filesystem::path& file, const std::vector<CategoryModel>& models);

}  // namespace armature
