// SPDX-License-Identifier: BSD-3-Clause
#include "eval/run_evaluation.h"

#include <fmt/format.h>

#include <algorithm>

#include "eval/true_scene.h"
#include "io/errors.h"
#include "io/nearest_name.h"
#include "io/sequence.h"

namespace armature {
namespace {

size_t EdgeIndex(const RunResults& run, const CategorySpec& spec, const std::string& name) {
  const auto found = std::find(spec.edge_names.begin(), spec.edge_names.end(), name);
  if (found == spec.edge_names.end()) {
    throw InputError(fmt::format("{}: a {} has an {}", (run.folder / "associations.csv").string(), spec.name,
                                 UnknownNameMessage("edge", name, spec.edge_names)));
  }
  return static_cast<size_t>(found - spec.edge_names.begin());
}

// A match: the physical edge that it names, and its segment.
struct NamedSegment {
  size_t edge;
  Segment segment;
};

RightMatches CountRight(const std::vector<NamedSegment>& matches, const std::vector<VisibleEdge>& edges,
                        const EdgeTolerance& tolerance) {
  RightMatches right;
  std::vector<bool> found(edges.size(), false);
  for (const NamedSegment& match : matches) {
    if (!LiesOnEdge(match.segment, edges[match.edge], tolerance)) continue;
    ++right.matches;
    found[match.edge] = true;
  }
  for (size_t i = 0; i < edges.size(); ++i) {
    right.edges += found[i] && edges[i].visible_length() >= kLeastVisiblePixels ? 1 : 0;
  }
  return right;
}

// `named[e]`: the physical edge that the estimate calls e.
MatchCounts CountMatches(const RunResults& run, const CategorySpec& spec, const RunObservation* observation,
                         const std::vector<VisibleEdge>& edges, const std::vector<int>& named) {
  std::vector<NamedSegment> matches;
  if (observation && observation->T_camera_object) {
    for (const RunMatch& match : observation->matches) {
      matches.push_back({static_cast<size_t>(named[EdgeIndex(run, spec, match.edge)]), match.segment});
    }
  }
  MatchCounts counts;
  counts.matches = static_cast<int>(matches.size());
  counts.visible_edges =
      static_cast<int>(std::count_if(edges.begin(), edges.end(), [](const VisibleEdge& edge) {
        return edge.visible_length() >= kLeastVisiblePixels;
      }));
  counts.on_edge = CountRight(matches, edges, kOnEdge);
  counts.near_edge = CountRight(matches, edges, kNearEdge);
  return counts;
}

EvaluatedDetection Evaluate(const RunResults& run, const TrueScene& scene, const GroundTruth& truth,
                            size_t object, const Eigen::Isometry3d& T_world_camera,
                            const RunObservation* observation) {
  const CategorySpec& spec = scene.spec(object);
  const Eigen::Isometry3d T_true = T_world_camera.inverse() * truth.objects[object].T_world_object;
  EvaluatedDetection row;
  row.object = truth.objects[object].id;
  row.category = spec.name;
  row.status = observation ? observation->status : "missing";
  int step = 0;
  if (observation && observation->T_camera_object) {
    const Eigen::Isometry3d& T_estimated = *observation->T_camera_object;
    row.error = CompareObservation(spec.name, spec.symmetry_order, observation->ok(), T_estimated, T_true);
    step = NearestSymmetryStep(T_estimated.linear(), T_true.linear(), spec.symmetry_order);
  }
  if (const auto edges = scene.EdgesSeen(object, T_world_camera)) {
    const auto named = SymmetricCounterparts(*scene.wireframe(object), spec.symmetry_order, step);
    row.matches = CountMatches(run, spec, observation, *edges, named);
  }
  return row;
}

}  // namespace

SequenceTruth LoadSequenceTruth(const std::filesystem::path& folder) {
  const SequenceSettings settings = ReadSequenceSettings(folder / "sequence.yaml");
  return {settings.name, settings.camera, LoadGroundTruth(folder)};
}

RunEvaluation EvaluateRun(const RunResults& run, const SequenceTruth& sequence,
                          const std::vector<CategorySpec>& specs, const CadLibrary& cad) {
  const GroundTruth& truth = sequence.truth;
  const TrueScene scene(sequence.camera, truth, specs, cad);
  RunEvaluation evaluation;
  evaluation.sequence = sequence.name;
  for (const auto& [key, object] : truth.detections) {
    const double timestamp = static_cast<double>(key.first) / 1e6;
    const std::optional<size_t> camera = IndexOfStamp(truth.T_world_camera, timestamp);
    if (!camera) continue;
    evaluation.detections.push_back(Evaluate(run, scene, truth, object, truth.T_world_camera[*camera].pose,
                                             run.Find(timestamp, key.second)));
    evaluation.detections.back().timestamp = timestamp;
    evaluation.detections.back().index = key.second;
  }
  for (const auto& [key, observation] : run.observations) {
    if (!truth.TrueCameraObject(observation.timestamp, observation.index)) ++evaluation.without_truth;
  }
  return evaluation;
}

}  // namespace armature
