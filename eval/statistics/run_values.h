// SPDX-License-Identifier: BSD-3-Clause
// What a run's quality is judged by, value by value, to be paired with another run's.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "cli/compared_values.h"
#include "eval/objects/run_objects.h"

namespace armature {

// Errors against the truth in the sequence folder, as far as it has one: of the camera (groundtruth.txt), of
// single views (objects_gt.csv, detections_gt.csv), and of the map's objects (all of them). The camera and
// the map are brought to the truth as `options` say. Throws InputError: a malformed file, no camera at a time
// of the truth, a true object's category without model.
std::vector<NamedValues> ComputeRunErrors(const std::filesystem::path& run,
                                          const std::filesystem::path& truth,
                                          const std::vector<CategoryModel>& models,
                                          const ObjectEvaluationOptions& options);

// timings.csv of a run folder: milliseconds a frame, in all and a stage. Throws InputError: malformed.
std::vector<NamedValues> ReadRunTimes(const std::filesystem::path& run);

// What loading the images tells of the machine, which no option changes: a line where it took longer in one
// of two runs than in the other, by more than chance and more than 15 %. None where it did not.
std::optional<std::string> PaceRemark(const std::vector<ComparedValues>& compared);

}  // namespace armature
