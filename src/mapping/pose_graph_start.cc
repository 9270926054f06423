// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_graph_start.h"

#include "mapping/chordal_initialisation.h"
#include "mapping/spanning_tree.h"

namespace armature {
namespace {

// A start is poor when its whitened residuals have a root mean square above 3. Where the information is
// honest it is at most about 1 at the optimum, so on average such a start contradicts each measurement by
// more than three standard deviations: it lies outside of what the measurements leave open. Information that
// claims too little keeps the given start, one that claims too much costs the time of a chordal one.
constexpr double kPoorResidual = 3;

// A lower cost does not prove a better basin, but a chordal start has no wrong turns of its own to hide: what
// it leaves is the noise of the measurements.
StartingPoses AutomaticStart(const PoseGraph& graph) {
  const double given_cost = PoseGraphCost(graph, graph.poses);
  const double residuals = 6.0 * static_cast<double>(graph.edges.size());
  if (!(given_cost > kPoorResidual * kPoorResidual * residuals)) return {PoseGraphStart::kGiven, graph.poses};
  StartingPoses chordal{PoseGraphStart::kChordal, ChordalPoses(graph)};
  if (PoseGraphCost(graph, chordal.poses) < given_cost) return chordal;
  return {PoseGraphStart::kGiven, graph.poses};
}

}  // namespace

StartingPoses FindStartingPoses(const PoseGraph& graph, PoseGraphStart start) {
  switch (start) {
    case PoseGraphStart::kAuto:
      return AutomaticStart(graph);
    case PoseGraphStart::kOdometry:
      return {start, ChainedPoses(graph)};
    case PoseGraphStart::kChordal:
      return {start, ChordalPoses(graph)};
    case PoseGraphStart::kGiven:
      break;
  }
  return {PoseGraphStart::kGiven, graph.poses};
}

}  // namespace armature
