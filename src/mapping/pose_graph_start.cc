// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_graph_start.h"

#include "mapping/chordal_initialisation.h"
#include "mapping/spanning_tree.h"

namespace armature {
namespace {

// The mean square of whitened residuals that noise alone explains: about 1 where the information is honest. A
// start below it lies among what the measurements leave open, and iterations reach the optimum from there.
// One above may be poor, or the information may claim too much: the chordal start, worth an iteration or two
// of time, decides.
constexpr double kExplained = 1;

// A lower cost does not prove a better basin, but a chordal start has no wrong turns of its own to hide: what
// it leaves is the noise of the measurements.
StartingPoses AutomaticStart(const PoseGraph& graph) {
  const double given_cost = PoseGraphCost(graph, graph.poses);
  const double residuals = 6.0 * static_cast<double>(graph.edges.size());
  if (given_cost <= kExplained * residuals) return {PoseGraphStart::kGiven, graph.poses};
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
