// SPDX-License-Identifier: BSD-3-Clause
#include "eval/views/run_evaluation.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "truth/true_scene.h"

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

// None without pose: it is what tells under which symmetric turn the names are meant.
std::vector<NamedSegment> ReadMatches(const RunResults& run, const CategorySpec& spec,
                                      const RunObservation* observation) {
  std::vector<NamedSegment> matches;
  if (!observation || !observation->T_camera_object) return matches;
  for (const RunMatch& match : observation->matches)
    matches.push_back({EdgeIndex(run, spec, match.edge), match.segment});
  return matches;
}

EvaluatedDetection Evaluate(const RunResults& run, const TrueScene& scene, const GroundTruth& truth,
                            size_t object, const TimedPose& T_world_camera,
                            const RunObservation* observation) {
  const CategorySpec& spec = scene.spec(object);
  const Eigen::Isometry3d T_true = T_world_camera.pose.inverse() * truth.objects[object].T_world_object;
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
    const auto named = SymmetricCounterparts(scene.mean_wireframe(object), spec.symmetry_order, step);
    JudgedMatches judged = JudgeMatches(ReadMatches(run, spec, observation), spec, *edges, named);
    row.matches = judged.counts;
    row.judged = std::move(judged.rows);
  }
  return row;
}

void CountFalseAlarms(const RunResults& run, const GroundTruth& truth, RunEvaluation& evaluation) {
  evaluation.false_alarms = static_cast<int>(truth.false_alarms.size());
  for (const auto& [microseconds, index] : truth.false_alarms) {
    const RunObservation* observation = run.Find(static_cast<double>(microseconds) / 1e6, index);
    evaluation.trusted_false_alarms +=
        observation && observation->ok() && observation->T_camera_object ? 1 : 0;
  }
}

}  // namespace

RunEvaluation EvaluateRun(const RunResults& run, const SequenceTruth& sequence,
                          const std::vector<CategoryModel>& models, const CadLibrary& cad) {
  const GroundTruth truth = TruthOfRun(sequence.truth, run);
  const TrueScene scene(sequence, models, cad);
  RunEvaluation evaluation;
  evaluation.sequence = sequence.name;
  evaluation.has_true_edges = sequence.edges.has_value();
  for (const auto& [key, object] : truth.detections) {
    ThrowIfInterrupted();
    const double timestamp = static_cast<double>(key.first) / 1e6;
    const std::optional<size_t> camera = FindStamp(truth.T_world_camera, timestamp);
    if (!camera) continue;
    evaluation.detections.push_back(
        Evaluate(run, scene, truth, object, truth.T_world_camera[*camera], run.Find(timestamp, key.second)));
    evaluation.detections.back().timestamp = timestamp;
    evaluation.detections.back().index = key.second;
  }
  for (const auto& [key, observation] : run.observations) {
    if (!truth.TrueCameraObject(observation.timestamp, observation.index)) ++evaluation.without_truth;
  }
  CountFalseAlarms(run, truth, evaluation);
  return evaluation;
}

}  // namespace armature
