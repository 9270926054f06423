// SPDX-License-Identifier: BSD-3-Clause
// Micro-benchmark of the nearest neighbours of a vector of seven numbers, as descriptors of objects have.
#pragma once

#include <vector>

#include "bench/micro/micro_benchmark.h"

namespace armature {

// neighbours, one for each number of points.
std::vector<MicroBenchmark> NeighbourBenchmarks(const MicroSetup& setup);

}  // namespace armature
