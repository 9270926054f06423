// SPDX-License-Identifier: BSD-3-Clause
// How far two runs of one sequence are from each other, where no truth says which is better.
#pragma once

#include <filesystem>
#include <vector>

#include "category/category_model.h"
#include "cli/compared_values.h"
#include "eval/objects/run_objects.h"

namespace armature {

inline constexpr const char* kCameraDistance = "camera positions [m]";

// Run b judged as if run a were the truth: of its objects (matched one-to-one, see MatchByDistance), by a's
// ids, and of its cameras, after the alignment of the options. Values of `a` are 0, those of `b` the
// distance. Nothing of a run without camera poses, nor of what neither of them has. Throws InputError: a
// malformed file, a category without specification.
std::vector<ComparedValues> ResultDistances(const std::filesystem::path& run_a,
                                            const std::filesystem::path& run_b,
                                            const std::vector<CategorySpec>& specs,
                                            const ObjectEvaluationOptions& options);

// A row a distance: its median, mean and greatest value.
Table DistanceTable(const std::vector<ComparedValues>& distances);

}  // namespace armature
