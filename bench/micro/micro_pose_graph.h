// SPDX-License-Identifier: BSD-3-Clause
// Micro-benchmark of the pose graph's solver.
#pragma once

#include "bench/micro/micro_benchmark.h"
#include "mapping/pose_graph.h"

namespace armature {

// A walk around a sphere in as many turns as poses a turn, measured along the walk and from turn to turn,
// like sphere2500. Its poses are those of the noisy odometry, far from the optimum at the end of the walk.
PoseGraph NoisySphere(size_t poses);

// pose_graph, one for each size.
std::vector<MicroBenchmark> PoseGraphBenchmarks(const MicroSetup& setup);

}  // namespace armature
