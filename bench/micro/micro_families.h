// SPDX-License-Identifier: BSD-3-Clause
// The families of micro-benchmarks: association (hypotheses, what one costs, matching), resection and a whole
// object, the nearest neighbours of vectors of seven numbers, as descriptors of objects have, and the solver
// of pose graphs.
#pragma once

#include <vector>

#include "bench/micro/micro_benchmark.h"
#include "bench/micro/micro_view.h"
#include "mapping/pose_graph.h"

namespace armature {

// What the search of pipeline/object_estimator.h does for a hypothesis that it does not prune: projection,
// cost without lines, visibility and explained length.
double HypothesisCost(const MicroView& micro, const Hypothesis& hypothesis, const AssociationOptions& options,
                      ProjectedWireframe& scratch);

// The gate of the search and, tighter, that of the reported matches.
MatchGate SearchGate(const ObjectView& view, const AssociationOptions& options);
MatchGate FinalGate(const AssociationOptions& options);

// hypothesis, hypotheses and matching, each for every model.
std::vector<MicroBenchmark> AssociationBenchmarks(const MicroSetup& setup);

// Matched lines to resect from: at most so many.
std::vector<EdgeMatch> MicroMatches(const MicroView& micro, size_t lines, const AssociationOptions& options);

// resection, alternating and object, each for every model.
std::vector<MicroBenchmark> ResectionBenchmarks(const MicroSetup& setup);

// neighbours, one for each number of points.
std::vector<MicroBenchmark> NeighbourBenchmarks(const MicroSetup& setup);

// A walk around a sphere in as many turns as poses a turn, measured along the walk and from turn to turn,
// like sphere2500. Its poses are those of the noisy odometry, far from the optimum at the end of the walk.
PoseGraph NoisySphere(size_t poses);

// pose_graph, one for each size.
std::vector<MicroBenchmark> PoseGraphBenchmarks(const MicroSetup& setup);

}  // namespace armature
