// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/object_map.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace armature {
namespace {

double GateOfRound(const RefinementOptions& options, int round) {
  const double progress = options.rounds > 1 ? round / (options.rounds - 1.0) : 1.0;
  return options.first_gate_pixels * std::pow(options.last_gate_pixels / options.first_gate_pixels, progress);
}

// Bearings that disagree would rather have the camera travel less: while single views with their errors of
// depth are all there is, the scale stays as the front end learnt it.
void SolveWithScaleHeld(MapGraph& graph, const MapSolverOptions& options) {
  const bool known = std::exchange(graph.scale_is_known, true);
  SolveMapGraph(graph, options);
  graph.scale_is_known = known;
}

Map ToMap(const std::vector<MapFrame>& frames, const MapGraph& graph, const ObjectOfObservation& phi, int min_observations) {
  Map map;
  map.T_world_camera = graph.T_world_camera;
  map.log_scale = graph.log_scale;
  const double scale = std::exp(std::accumulate(graph.log_scale.begin(), graph.log_scale.end(), 0.0) / static_cast<double>(graph.log_scale.size()));
  for (const MapFrame& frame : frames) {
    map.timestamps.push_back(frame.timestamp);
    map.T_world_camera_odometry.push_back(frame.T_odom_camera);
    map.T_world_camera_odometry.back().translation() *= scale;
  }
  std::vector<int> observations(graph.objects.size(), 0);
  for (const ObjectFactor& factor : graph.observations) ++observations[static_cast<size_t>(factor.object)];
  std::vector<int> kept(graph.objects.size(), -1);
  std::map<std::string, int> numbers;
  for (size_t i = 0; i < phi.size(); ++i) {
    map.phi.emplace_back(phi[i].size(), -1);
    for (size_t j = 0; j < phi[i].size(); ++j) {
      if (phi[i][j] < 0) continue;
      const auto o = static_cast<size_t>(phi[i][j]);
      if (observations[o] < min_observations) continue;
      const GraphObject& object = graph.objects[o];
      if (kept[o] < 0) {
        kept[o] = static_cast<int>(map.objects.size());
        const std::string& category = object.model->spec.name;
        map.objects.push_back({category + std::to_string(numbers[category]++), object.model, object.T_world_object, object.coefficients, observations[o]});
      }
      map.phi[i][j] = kept[o];
    }
  }
  return map;
}

}  // namespace

Map SolveMap(const std::vector<MapFrame>& frames, double initial_scale, const BoxOptions& box,
             const ResectionOptions& resection, const MappingOptions& options) {
  using Clock = std::chrono::steady_clock;
  auto t0 = Clock::now();
  const auto report = [&](const std::string& name, const MapGraph& graph, const MapSolution& s) {
    if (!getenv("MAPLOG")) return;
    fmt::print(stderr, "{}: {:.1f} -> {:.1f} in {} its, {:.0f} ms, objects {}, factors {}, scale", name, s.initial_cost, s.final_cost, s.iterations, std::chrono::duration<double, std::milli>(Clock::now() - t0).count(), graph.objects.size(), graph.observations.size());
    for (double l : graph.log_scale) fmt::print(stderr, " {:.3f}", std::exp(l));
    fmt::print(stderr, "\n");
    t0 = Clock::now();
  };
  const std::optional<double> seconds_between = options.loop_closure ? std::nullopt : std::optional(options.recent_seconds);
  MapGraph graph = GraphOfOdometry(frames, initial_scale, options.odometry);
  ObjectOfObservation phi = BreakTracks(frames, options.recent_seconds, options.min_observations);
  AddObjects(frames, phi, options.view_noise, graph);
  SolveWithScaleHeld(graph, options.solver);
  report("first", graph, {});
  while (const std::optional<Join> join = FindJoin(graph, frames, seconds_between, options.association)) {
    Apply(*join, graph, phi);
    SolveWithScaleHeld(graph, options.solver);
    report(fmt::format("join {} {} turn {:.2f} {}", join->kept, join->joined, join->turn, join->flipped), graph, {});
  }
  double final_cost = 0;
  for (int round = 0; round < options.refinement.rounds; ++round) {
    phi = AssociateDetections(graph, frames, phi, seconds_between, options.association);
      ResectionOptions of_round = resection;
    const double progress = options.refinement.rounds > 1 ? round / (options.refinement.rounds - 1.0) : 1.0;
    of_round.box_loss_scale = options.refinement.first_box_loss_scale * std::pow(resection.box_loss_scale / options.refinement.first_box_loss_scale, progress);
    Relinearise(frames, phi, GateOfRound(options.refinement, round), box, of_round, options.refinement, graph);
    report("relinearise", graph, {});
    final_cost = SolveMapGraph(graph, options.solver).final_cost;
  }
  Map map = ToMap(frames, graph, phi, options.min_observations);
  map.final_cost = final_cost;
  return map;
}

}  // namespace armature
