// SPDX-License-Identifier: BSD-3-Clause
// A race in which the calibration loop takes part.
#pragma once

#include "bench/bench_report.h"

namespace armature {

// The section gets the contenders' rows, and the calibration's times apart from them. The loop has the turn
// before the first contender's, but where that is the first of an input: what slept or emptied the caches
// just before, as baselines do, is felt by the loop and less by our engine, which is named first. Throws as
// Race.
void RaceCalibrated(std::vector<Contender> contenders, size_t inputs, const HarnessOptions& options,
                    BenchSection& section);

}  // namespace armature
