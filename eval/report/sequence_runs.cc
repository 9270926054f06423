// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/sequence_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/interrupt.h"
#include "category/category_lookup.h"
#include "io/shape_evidence_csv.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::optional<SequenceTruth> TruthAt(const fs::path& folder, const std::vector<CategorySpec>& specs) {
  for (const char* file : {"sequence.yaml", "groundtruth.txt", "objects_gt.csv", "detections_gt.csv"}) {
    if (!fs::exists(folder / file)) return std::nullopt;
  }
  return LoadSequenceTruth(folder, specs);
}

// Whatever is wrong with them, the rest of the report can do without.
std::optional<Sequence> ImagesAt(const fs::path& folder, const RunResults& run,
                                 const std::vector<CategorySpec>& specs, std::vector<std::string>& remarks) {
  std::vector<std::string> categories;
  for (const CategorySpec& spec : specs) categories.push_back(spec.name);
  try {
    return LoadSequence(folder, categories, {}, run.detections);
  } catch (const InputError& error) {
    remarks.push_back(
        fmt::format("{}: no overlays and no crops of its images: {}", run.sequence, error.what()));
    return std::nullopt;
  }
}

// Coefficients of other models would draw other furniture.
void CheckModels(const fs::path& run, const std::vector<PlacedObject>& objects,
                 const std::vector<CategoryModel>& models) {
  const fs::path evidence_file = run / "shape_evidence.csv";
  std::map<std::string, StoredEvidence> evidence;
  if (fs::exists(evidence_file)) evidence = ReadShapeEvidence(evidence_file);
  for (const PlacedObject& object : objects) {
    const CategoryModel* model = FindModel(models, object.category);
    const auto known = evidence.find(object.id);
    if (model == nullptr || static_cast<int>(object.shape.size()) != model->modes() ||
        (known != evidence.end() && known->second.model_checksum != ModelChecksum(*model))) {
      throw InputError(fmt::format(
          "{}: the shape of '{}' is of another model of its category; name the models that the run was made "
          "with (--categories), or run it again",
          (run / "objects.csv").string(), object.id));
    }
  }
}

std::vector<TimedPose> Moved(std::vector<TimedPose> cameras, const Similarity& T_truth_run) {
  for (TimedPose& camera : cameras) camera.pose = T_truth_run.Apply(camera.pose);
  return cameras;
}

// As it is told in the run's files. A run that placed nothing may have had no odometry.
std::optional<ShownMap> OwnMap(const LoadedRun& run, bool by_odometry) {
  const fs::path file = run.results.folder / (by_odometry ? "objects_odometry.csv" : "objects.csv");
  const fs::path cameras = run.results.folder / (by_odometry ? "odometry_scaled.txt" : "trajectory.txt");
  if (!fs::exists(file)) return std::nullopt;
  std::vector<PlacedObject> objects = ReadPlacedObjects(file);
  if (objects.empty()) return std::nullopt;
  return ShownMap{
      FindApproach(by_odometry, run.configuration), ReadTumTrajectory(cameras), std::move(objects), {}};
}

void BringToTruth(const SequenceTruth& truth, const std::vector<CategorySpec>& specs, LoadedRun& run) {
  for (EvaluatedMap& evaluated : EvaluateRunObjects(run.results, truth, specs, {}).maps) {
    std::optional<ShownMap>& map = evaluated.is_by_odometry() ? run.odometry : run.map;
    if (!map) continue;
    map->T_world_camera = Moved(std::move(map->T_world_camera), evaluated.T_truth_run);
    map->objects = Moved(std::move(map->objects), evaluated.T_truth_run);
    map->evaluated = std::move(evaluated.by_distance);
  }
}

LoadedRun LoadSourceRun(const ReportSources::Run& source, const ReportSources& sources) {
  LoadedRun run{source.name, LoadRun(source.folder), ReadRunConfiguration(source.folder), {}, {}};
  run.map = OwnMap(run, false);
  run.odometry = OwnMap(run, true);
  for (const std::optional<ShownMap>& map : {run.map, run.odometry}) {
    if (map) CheckModels(source.folder, map->objects, sources.models);
  }
  return run;
}

Eigen::Vector3d FindUp(const SequenceRuns& sequence) {
  Eigen::Vector3d sum(0, 0, 0);
  if (sequence.truth) {
    for (const TrueObject& object : sequence.truth->truth.objects)
      sum += object.T_world_object.linear().col(1);
  } else if (const std::optional<ShownMap>& map = sequence.runs.front().map) {
    for (const PlacedObject& object : map->objects) sum += object.T_world_object.linear().col(1);
  }
  return sum.norm() > 0 ? sum.normalized() : Eigen::Vector3d(0, -1, 0);
}

SequenceRuns StartSequence(const RunResults& run, const fs::path& folder,
                           const std::vector<CategorySpec>& specs, std::vector<std::string>& remarks) {
  SequenceRuns sequence;
  sequence.name = run.sequence;
  sequence.truth = TruthAt(folder, specs);
  if (!sequence.truth)
    remarks.push_back(
        fmt::format("{}: has no ground truth of cameras and objects: no errors are shown", run.sequence));
  sequence.images = ImagesAt(folder, run, specs, remarks);
  return sequence;
}

}  // namespace

std::vector<SequenceRuns> LoadSequenceRuns(const ReportSources& sources, std::vector<std::string>& remarks) {
  const std::vector<CategorySpec> specs = CollectSpecs(sources.models);
  std::vector<SequenceRuns> sequences;
  for (const ReportSources::Run& source : sources.runs) {
    ThrowIfInterrupted();
    LoadedRun run = LoadSourceRun(source, sources);
    const std::string& name = run.results.sequence;
    auto found = std::find_if(sequences.begin(), sequences.end(),
                              [&](const SequenceRuns& sequence) { return sequence.name == name; });
    if (found == sequences.end())
      found = sequences.insert(found, StartSequence(run.results, source.sequence, specs, remarks));
    if (found->truth) BringToTruth(*found->truth, specs, run);
    found->runs.push_back(std::move(run));
  }
  for (SequenceRuns& sequence : sequences) sequence.up = FindUp(sequence);
  return sequences;
}

const TimedPose* CameraAt(const ShownMap& map, double timestamp) {
  const std::optional<size_t> index = FindStamp(map.T_world_camera, timestamp);
  return index ? &map.T_world_camera[*index] : nullptr;
}

}  // namespace armature
