// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/solve_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "mapping/estimate_over_views.h"
#include "mapping/far_start.h"
#include "mapping/object_evidence.h"
#include "mapping/object_search.h"
#include "mapping/seen_objects.h"

namespace armature {
namespace {

constexpr double kLeastScaleSigma = 0.005;  // of the map's scale, when shapes are told: never surer

// Of objects that stay in the map, in the first pass and in the last.
constexpr std::array kLeastProbability{0.2, 0.5};

struct MapInput {
  const std::vector<MapFrame>& frames;
  const BoxOptions& box;
  const ResectionOptions& resection;
  const MappingOptions& options;
};

// Bearings that disagree would rather have the camera travel less: while single views with their errors of
// depth are all there is, the scale stays as the front end learnt it.
MapSolution SolveWithScaleHeld(MapGraph& graph, const MapSolverOptions& options) {
  const bool held = std::exchange(graph.scale_is_held, true);
  const MapSolution solution = SolveMapGraph(graph, options);
  graph.scale_is_held = held;
  return solution;
}

// Of merges that exclude each other, makes the one that costs the solved graph least: a wrong one bends the
// odometry more, or its views disagree. A loop that closes moves the cameras.
void MakeBest(const std::vector<Merge>& merges, const MapSolverOptions& options, MapGraph& graph,
              ObjectOfObservation& phi) {
  struct Outcome {
    MapGraph graph;
    ObjectOfObservation phi;
    double cost = 0;
  };
  std::optional<Outcome> best;
  for (const Merge& merge : merges) {
    Outcome outcome{graph, phi};
    ApplyMerge(merge, outcome.graph, outcome.phi);
    outcome.cost = SolveWithScaleHeld(outcome.graph, options).final_cost;
    if (!best || outcome.cost < best->cost) best = std::move(outcome);
  }
  graph = std::move(best->graph);
  phi = std::move(best->phi);
}

void MergeWhileSolving(const std::vector<MapFrame>& frames, const MappingOptions& options, MapGraph& graph,
                       ObjectOfObservation& phi) {
  SolveWithScaleHeld(graph, options.solver);
  const auto find = [&] { return FindMerges(graph, frames, SecondsBetween(options), options.association); };
  for (std::vector<Merge> merges = find(); !merges.empty(); merges = find()) {
    MakeBest(merges, options.solver, graph, phi);
  }
}

// Once factors are linearised at the map's poses and not at their own optima, only what lies in one place is
// joined.
void MergeOverlapping(const std::vector<MapFrame>& frames, const MappingOptions& options, MapGraph& graph,
                      ObjectOfObservation& phi) {
  ObjectAssociationOptions only_overlap = options.association;
  only_overlap.gate = 0;
  const auto find = [&] { return FindMerges(graph, frames, SecondsBetween(options), only_overlap); };
  for (std::vector<Merge> merges = find(); !merges.empty(); merges = find())
    ApplyMerge(merges.front(), graph, phi);
}

void Refine(const MapInput& input, MapGraph& graph, ObjectOfObservation& phi) {
  const MappingOptions& options = input.options;
  MapSolverOptions solver = options.solver;
  solver.max_iterations = kRefinementSteps;
  for (int round = 0; round < options.refinement.rounds; ++round) {
    if (!graph.observations.empty()) MergeOverlapping(input.frames, options, graph, phi);
    Relinearise(input.frames, phi, round, input.box, input.resection, options.refinement, graph);
    DropUnseen(graph, phi);
    SolveMapGraph(graph, solver);
  }
}

// Anew, by all detections, where the graph has the cameras.
ObjectOfObservation FindObjects(const MapInput& input, MapGraph& graph) {
  ObjectSearchOptions options;
  options.least_observations = input.options.min_observations;
  std::vector<ObjectCandidate> found = SearchObjects(input.frames, graph.T_world_camera, options);
  if (const auto seconds = SecondsBetween(input.options))
    found = BreakAtGaps(input.frames, found, *seconds, options.least_observations);
  ObjectOfObservation phi;
  for (const MapFrame& frame : input.frames) phi.emplace_back(frame.observations.size(), -1);
  graph.objects.clear();
  graph.observations.clear();
  for (ObjectCandidate& candidate : found) {
    for (const auto& [i, j] : candidate.views) phi[i][j] = static_cast<int>(graph.objects.size());
    graph.objects.push_back(std::move(candidate.object));
  }
  return phi;
}

// Each by itself, the cameras held.
void EstimateObjects(const MapInput& input, const ObjectOfObservation& phi, MapGraph& graph) {
  std::vector<SeenObjects> seen(input.frames.size());
  std::vector<std::vector<std::pair<size_t, size_t>>> views(graph.objects.size());
  for (size_t i = 0; i < input.frames.size(); ++i) {
    const std::vector<MapObservation>& observations = input.frames[i].observations;
    if (!observations.empty()) seen[i] = SeeObjects(graph, i, *observations.front().view.camera);
    for (size_t j = 0; j < phi[i].size(); ++j) {
      if (phi[i][j] >= 0) views[static_cast<size_t>(phi[i][j])].emplace_back(i, j);
    }
  }
  std::vector<GraphObject> estimated;
  for (size_t o = 0; o < graph.objects.size(); ++o) {
    estimated.push_back(
        EstimateOverViews({input.frames, graph, seen, input.box, input.resection}, o, views[o]));
  }
  graph.objects = std::move(estimated);
}

void DropUnlikely(const MapInput& input, double least_probability, MapGraph& graph,
                  ObjectOfObservation& phi) {
  const std::vector<ObjectEvidence> evidence = CollectEvidence(input.frames, phi, graph, input.box);
  std::erase_if(graph.observations, [&](const ObjectFactor& factor) {
    return ComputeProbability(evidence[static_cast<size_t>(factor.object)]) < least_probability;
  });
  DropUnseen(graph, phi);
}

// Without the images' lines: what the front end's tracks and single views say.
ObjectOfObservation SolveFromTracks(const std::vector<MapFrame>& frames, const MappingOptions& options,
                                    MapGraph& graph) {
  ObjectOfObservation phi = BreakTracks(frames, options.recent_seconds, options.min_observations);
  AddObjects(frames, phi, graph);
  MergeWhileSolving(frames, options, graph, phi);
  return phi;
}

// The odometry drifts: what is seen again after a long way is found twice, side by side. Where single views
// say that two are one, they are, and the cameras go where that is so.
void CloseLoops(const MapInput& input, MapGraph& graph, ObjectOfObservation& phi) {
  MapGraph merged = graph;
  ObjectOfObservation merged_phi = phi;
  AddViewFactors(input.frames, phi, merged);
  MergeWhileSolving(input.frames, input.options, merged, merged_phi);
  if (merged.objects.size() == graph.objects.size()) return;
  graph = std::move(merged);
  graph.observations.clear();
  phi = std::move(merged_phi);
}

// By all detections and lines, whatever the front end made of them. The first pass brings cameras and scale
// near; what it took for objects and was none bent them, so the second begins anew.
ObjectOfObservation SolveFromDetections(const MapInput& input, MapGraph& graph) {
  ObjectOfObservation phi;
  graph.sizes_are_held = false;
  for (const double least_probability : kLeastProbability) {
    phi = FindObjects(input, graph);
    CloseLoops(input, graph, phi);
    EstimateObjects(input, phi, graph);
    Refine(input, graph, phi);
    DropUnlikely(input, least_probability, graph, phi);
    Refine(input, graph, phi);
  }
  return phi;
}

// Objects that enough observations support, numbered in the order in which they are first seen.
void StoreObjects(const MapGraph& graph, const ObjectOfObservation& phi,
                  const std::vector<std::optional<ObjectUncertainty>>& uncertainties,
                  const MappingOptions& options, Map& map) {
  const double scale_sigma = std::max(map.scale_sigma.value_or(0), kLeastScaleSigma);
  std::vector<int> observations(graph.objects.size(), 0);
  for (const ObjectFactor& factor : graph.observations) ++observations[static_cast<size_t>(factor.object)];
  std::vector<int> kept(graph.objects.size(), -1);
  std::map<std::string, int> numbers;
  for (const std::vector<int>& of_frame : phi) {
    map.phi.emplace_back(of_frame.size(), -1);
    for (size_t j = 0; j < of_frame.size(); ++j) {
      if (of_frame[j] < 0) continue;
      const auto o = static_cast<size_t>(of_frame[j]);
      if (observations[o] < options.min_observations) continue;
      if (kept[o] < 0) {
        kept[o] = static_cast<int>(map.objects.size());
        const GraphObject& object = graph.objects[o];
        const std::string& category = object.model->spec.name;
        map.objects.push_back({category + std::to_string(numbers[category]++), object.model,
                               object.T_world_object, object.coefficients, object.log_size, observations[o],
                               ComputeShapeEvidence(graph, of_frame[j], scale_sigma, options.solver),
                               uncertainties[o]});
      }
      map.phi.back()[j] = kept[o];
    }
  }
}

// The first camera stands where the odometry, times the map's mean scale, has it.
void Anchor(const Eigen::Isometry3d& T_odom_camera, Map& map) {
  const Eigen::Vector3d shift =
      map.MeanScale() * T_odom_camera.translation() - map.T_world_camera.front().translation();
  for (Eigen::Isometry3d& T_world_camera : map.T_world_camera) T_world_camera.pretranslate(shift);
  for (MapObject& object : map.objects) object.T_world_object.pretranslate(shift);
}

// Of each object of the graph, and the scale's. None where the images' lines were not used: single views know
// too little of each other's errors.
std::vector<std::optional<ObjectUncertainty>> ComputeUncertainties(const MapInput& input,
                                                                   const MapGraph& graph,
                                                                   const ObjectOfObservation& phi,
                                                                   std::optional<double>& scale_sigma) {
  std::vector<std::optional<ObjectUncertainty>> uncertainties(graph.objects.size());
  if (input.options.refinement.rounds == 0) return uncertainties;
  const std::optional<GraphUncertainty> of_graph = ComputeUncertainty(graph, input.options.solver);
  if (!of_graph) return uncertainties;
  scale_sigma = of_graph->scale_sigma;
  const std::vector<ObjectEvidence> evidence = CollectEvidence(input.frames, phi, graph, input.box);
  for (size_t o = 0; o < graph.objects.size(); ++o) {
    const double probability = ComputeProbability(evidence[o]);
    uncertainties[o] = {probability,
                        CovarianceOfPoseAndSize(graph.objects[o], of_graph->objects[o], probability)};
  }
  return uncertainties;
}

Map ToMap(const MapInput& input, const MapGraph& graph, const ObjectOfObservation& phi) {
  Map map;
  for (const MapFrame& frame : input.frames) map.timestamps.push_back(frame.timestamp);
  map.T_world_camera = graph.T_world_camera;
  map.log_scale = graph.log_scale;
  const auto uncertainties = ComputeUncertainties(input, graph, phi, map.scale_sigma);
  StoreObjects(graph, phi, uncertainties, input.options, map);
  if (map.scale_sigma && !map.objects.empty()) {
    std::vector<double> probabilities;
    for (const MapObject& object : map.objects) probabilities.push_back(object.uncertainty->probability);
    map.scale_sigma = WidenScaleSigma(*map.scale_sigma, probabilities);
  }
  Anchor(input.frames.front().T_odom_camera, map);
  return map;
}

// Single views that the front end was not sure of are left out, but for objects that have no other.
ObjectOfObservation WithoutUnsureViews(const std::vector<MapFrame>& frames, ObjectOfObservation phi,
                                       size_t objects) {
  const auto is_sure = [&](size_t i, size_t j) { return frames[i].observations[j].track >= 0; };
  std::vector<bool> has_sure(objects, false);
  for (size_t i = 0; i < phi.size(); ++i) {
    for (size_t j = 0; j < phi[i].size(); ++j) {
      if (phi[i][j] >= 0 && is_sure(i, j)) has_sure[static_cast<size_t>(phi[i][j])] = true;
    }
  }
  for (size_t i = 0; i < phi.size(); ++i) {
    for (size_t j = 0; j < phi[i].size(); ++j) {
      if (phi[i][j] >= 0 && has_sure[static_cast<size_t>(phi[i][j])] && !is_sure(i, j)) phi[i][j] = -1;
    }
  }
  return phi;
}

std::optional<Eigen::Vector3d> FindFarOdometry(const std::vector<MapFrame>& frames) {
  std::vector<Eigen::Isometry3d> poses;
  poses.reserve(frames.size());
  for (const MapFrame& frame : frames) poses.push_back(frame.T_odom_camera);
  return FindFarStart(poses);
}

std::vector<MapFrame> Moved(std::vector<MapFrame> frames, const Eigen::Vector3d& by) {
  for (MapFrame& frame : frames) frame.T_odom_camera.pretranslate(by);
  return frames;
}

Map Moved(Map map, const Eigen::Vector3d& by) {
  for (Eigen::Isometry3d& T_world_camera : map.T_world_camera) T_world_camera.pretranslate(by);
  for (MapObject& object : map.objects) object.T_world_object.pretranslate(by);
  return map;
}

}  // namespace

std::optional<double> SecondsBetween(const MappingOptions& options) {
  if (options.loop_closure) return std::nullopt;
  return options.recent_seconds;
}

Eigen::Vector3d MapObject::Size() const {
  return BoundingBoxSize(MakeWireframe()) + std::exp(log_size) * 2 * model->spec.padding;
}

Wireframe MapObject::MakeWireframe() const {
  Wireframe wireframe = WireframeFromCoefficients(*model, coefficients);
  wireframe.midpoints *= std::exp(log_size);
  wireframe.directions *= std::exp(log_size);
  return wireframe;
}

double Map::MeanScale() const {
  const double sum = std::accumulate(log_scale.begin(), log_scale.end(), 0.0);
  return std::exp(sum / static_cast<double>(log_scale.size()));
}

Map SolveMap(const std::vector<MapFrame>& frames, const ScaleEstimate& expected_scale, const BoxOptions& box,
             const ResectionOptions& resection, const MappingOptions& options) {
  if (const auto start = FindFarOdometry(frames)) {
    Map map = SolveMap(Moved(frames, -*start), expected_scale, box, resection, options);
    const Eigen::Vector3d by = map.MeanScale() * *start;
    return Moved(std::move(map), by);
  }
  const MapInput input{frames, box, resection, options};
  if (options.refinement.rounds == 0) {
    MapGraph graph = MakeOdometryGraph(frames, expected_scale, options.odometry);
    const ObjectOfObservation phi = SolveFromTracks(frames, options, graph);
    return ToMap(input, graph, phi);
  }
  const ScaleEstimate scale = SearchScale(frames, expected_scale, options.min_observations);
  MapGraph graph = MakeOdometryGraph(frames, scale, options.odometry);
  const ObjectOfObservation phi = SolveFromDetections(input, graph);
  return ToMap(input, graph, phi);
}

Map PlaceByOdometry(const std::vector<MapFrame>& frames, const Map& map, const MappingOptions& options) {
  if (const auto start = FindFarOdometry(frames)) {
    const Eigen::Vector3d by = map.MeanScale() * *start;
    return Moved(PlaceByOdometry(Moved(frames, -*start), Moved(map, -by), options), by);
  }
  MapGraph graph = MakeOdometryGraph(frames, {map.MeanScale(), 0}, options.odometry);
  graph.cameras_are_held = true;
  AddObjects(frames, WithoutUnsureViews(frames, map.phi, map.objects.size()), graph);
  SolveMapGraph(graph, options.solver);
  Map placed = map;
  placed.T_world_camera = graph.T_world_camera;
  placed.log_scale = graph.log_scale;
  placed.scale_sigma.reset();
  for (size_t o = 0; o < graph.objects.size(); ++o) {
    placed.objects[o].T_world_object = graph.objects[o].T_world_object;
    placed.objects[o].coefficients = graph.objects[o].coefficients;
    placed.objects[o].log_size = graph.objects[o].log_size;
    placed.objects[o].uncertainty.reset();
  }
  return placed;
}

}  // namespace armature
