// SPDX-License-Identifier: BSD-3-Clause
// A race in which the calibration loop takes part, and what is slow and remembers nothing takes part in a
// few frames only.
#pragma once

#include <functional>
#include <vector>

#include "bench/bench_report.h"
#include "bench/harness.h"

namespace armature {

// Warm-up inputs, the last ones, that such a contender sees.
inline constexpr size_t kSparseWarmUp = 2;

// The inputs in which it takes part, growing: those of the warm-up, and then about `count` of the used ones,
// evenly spread.
std::vector<size_t> SparseInputs(const std::function<bool(size_t input)>& is_used, size_t inputs,
                                 size_t warm_up, size_t count);

// Whether an input is one of those: what a contender wants.
std::function<bool(size_t input)> PickOne(std::vector<size_t> inputs);

// The section gets the contenders' rows, and the calibration's times apart from them. The loop has the turn
// before the first contender's, but where that is the first of an input: what slept or emptied the caches
// just before, as baselines do, is felt by the loop and less by our engine, which is named first. Throws as
// Race.
void RaceCalibrated(std::vector<Contender> contenders, size_t inputs, const HarnessOptions& options,
                    BenchSection& section);

}  // namespace armature
