// SPDX-License-Identifier: BSD-3-Clause
// Micro-benchmarks of resection, and of a whole object.
#pragma once

#include "bench/micro/micro_benchmark.h"
#include "bench/micro/micro_view.h"

namespace armature {

// Matched lines to resect from: at most so many.
std::vector<EdgeMatch> MicroMatches(const MicroView& micro, size_t lines, const AssociationOptions& options);

// resection, alternating and object, each for every model.
std::vector<MicroBenchmark> ResectionBenchmarks(const MicroSetup& setup);

}  // namespace armature
