// SPDX-License-Identifier: BSD-3-Clause
// Two benchmarks pass by pass: each frame against itself, so that frames of different content do not widen
// what is uncertain. As the guard's, ratios are divided by the
// calibration loop's.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/compared_values.h"

namespace armature {

// raw.csv of two bench folders: milliseconds of each table, sequence, contender and stage that both have,
// paired by repetition and frame (a key's series and index). Stages that mostly had nothing to do are left
// out. Throws InputError: a missing or malformed file.
std::vector<ComparedValues> PairPasses(const std::filesystem::path& raw_a,
                                       const std::filesystem::path& raw_b);

// A row a span: medians, and the ratio B / A with its interval. `calibration_ratio`: see GuardResult.
Table PassRatioTable(const std::vector<ComparedValues>& passes, double calibration_ratio);

}  // namespace armature
