// SPDX-License-Identifier: BSD-3-Clause
#include "eval/objects/run_objects.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

Similarity AlignTrajectory(const fs::path& trajectory, const SequenceTruth& sequence,
                           const ObjectEvaluationOptions& options) {
  const std::vector<PosePair> pairs =
      PairPoses(ReadTumTrajectory(trajectory), sequence.truth.T_world_camera, options.tolerance);
  if (pairs.empty()) {
    throw InputError(
        fmt::format("{}: no pose is at a time of the true trajectory of '{}'; give the ground truth of this "
                    "run's sequence",
                    trajectory.string(), sequence.name));
  }
  return Align(pairs, options.alignment, options.first_n);
}

EvaluatedMap EvaluateMap(const RunResults& run, const SequenceTruth& sequence,
                         const std::vector<CategorySpec>& specs, const ObjectEvaluationOptions& options,
                         bool by_odometry) {
  const GroundTruth truth = TruthOfRun(sequence.truth, run);
  EvaluatedMap evaluated;
  std::vector<PlacedObject> map =
      ReadPlacedObjects(run.folder / (by_odometry ? "objects_odometry.csv" : "objects.csv"));
  if (!map.empty()) {  // a run that placed nothing may have had no odometry
    evaluated.T_truth_run = AlignTrajectory(
        run.folder / (by_odometry ? "odometry_scaled.txt" : "trajectory.txt"), sequence, options);
  }
  map = Moved(std::move(map), evaluated.T_truth_run);
  evaluated.by_distance =
      EvaluateObjects(map, truth, specs, MatchByDistance(map, truth.objects, options.gate_m));
  const bool named = std::any_of(run.observations.begin(), run.observations.end(),
                                 [](const auto& entry) { return !entry.second.object.empty(); });
  if (named) evaluated.by_detections = EvaluateObjects(map, truth, specs, MatchByDetections(map, run, truth));
  return evaluated;
}

}  // namespace

std::string ApproachTitle(Approach approach) {
  switch (approach) {
    case Approach::kOdometryOnly:
      return "odometry only";
    case Approach::kObjects:
      return "objects";
    case Approach::kObjectsLoopClosure:
      return "objects, loop closure";
    case Approach::kObjectsNoLoopClosure:
      return "objects, no loop closure";
  }
  return "";
}

Approach FindApproach(bool by_odometry, const RunConfiguration& configuration) {
  if (by_odometry) return Approach::kOdometryOnly;
  if (!configuration.loop_closure) return Approach::kObjects;
  return *configuration.loop_closure ? Approach::kObjectsLoopClosure : Approach::kObjectsNoLoopClosure;
}

RunObjects EvaluateRunObjects(const RunResults& run, const SequenceTruth& sequence,
                              const std::vector<CategorySpec>& specs,
                              const ObjectEvaluationOptions& options) {
  RunObjects objects;
  objects.configuration = ReadRunConfiguration(run.folder);
  if (!fs::exists(run.folder / "objects.csv")) return objects;
  for (const bool by_odometry : {true, false}) {
    if (by_odometry && !fs::exists(run.folder / "objects_odometry.csv")) continue;
    objects.maps.push_back(EvaluateMap(run, sequence, specs, options, by_odometry));
    objects.maps.back().approach = FindApproach(by_odometry, objects.configuration);
  }
  return objects;
}

}  // namespace armature
