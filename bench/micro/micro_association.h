// SPDX-License-Identifier: BSD-3-Clause
// Micro-benchmarks of association: hypotheses, what one costs, and matching.
#pragma once

#include "bench/micro/micro_benchmark.h"
#include "bench/micro/micro_view.h"

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

}  // namespace armature
