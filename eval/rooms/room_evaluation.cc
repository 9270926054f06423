// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/room_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/errors.h"
#include "base/interrupt.h"
#include "category/category_lookup.h"
#include "eval/budget/substitution.h"
#include "eval/trajectories/trajectory_metrics.h"
#include "io/csv.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

void EvaluateCameras(const fs::path& run, const std::vector<TimedPose>& truth,
                     const ObjectEvaluationOptions& options, EvaluatedRoom& room) {
  const fs::path file = run / "trajectory.txt";
  if (ReadTextLines(file).empty()) return;  // without odometry
  const std::vector<TimedPose> cameras = ReadTumTrajectory(file);
  const std::vector<PosePair> pairs = PairPoses(cameras, truth, options.tolerance);
  if (pairs.empty()) return;
  if (const Similarity sim3 = Align(pairs, AlignmentKind::kSim3, 0); !sim3.is_degenerate && Moves(pairs))
    room.log_scale = -std::log(sim3.scale);
  const TrajectoryEvaluation moved = EvaluateTrajectory(
      cameras, truth,
      {.alignment = options.alignment, .first_n = options.first_n, .tolerance = options.tolerance});
  if (const auto error = AbsoluteError(moved)) room.ate_m = error->rmse;
}

void AddObjects(const RunObjects& objects, const std::vector<TrueObject>& truth,
                const std::vector<ObjectCircumstances>& circumstances, EvaluatedRoom& room) {
  if (objects.maps.empty()) return;
  for (const EvaluatedObject& object : objects.maps.back().by_distance) {
    if (object.status == ObjectStatus::kSpurious) ++room.spurious;
    if (object.status != ObjectStatus::kFound && object.status != ObjectStatus::kMissed) continue;
    const auto of_truth = std::find_if(truth.begin(), truth.end(),
                                       [&](const TrueObject& known) { return known.id == object.true_id; });
    room.objects.push_back({object, circumstances[static_cast<size_t>(of_truth - truth.begin())]});
  }
}

struct RoomTruth {
  SequenceTruth sequence;
  std::vector<CategoryModel> models;  // its own where its objects are categories of their own
};

RoomTruth LoadRoom(const RunToEvaluate& run, const std::vector<CategoryModel>& given) {
  for (const char* file : {"groundtruth.txt", "objects_gt.csv"}) {
    if (run.HasTruth(file)) continue;
    throw InputError(fmt::format("{}: has no {}, without which a run is in no room; leave out {}",
                                 run.truth.string(), file, run.run.folder.string()));
  }
  std::vector<CategoryModel> models = ModelsOfSequence(run.truth, given);
  SequenceTruth sequence = LoadSequenceTruth(run.truth, CollectSpecs(models));
  return {std::move(sequence), std::move(models)};
}

std::vector<ObjectCircumstances> DescribeObjectsFor(const RunResults& run, const SequenceTruth& truth,
                                                    const std::vector<CategoryModel>& models) {
  if (run.detections.empty()) return DescribeObjects(truth, models);
  SequenceTruth of_run = truth;
  of_run.truth = TruthOfRun(std::move(of_run.truth), run);
  return DescribeObjects(of_run, models);
}

fs::path Normal(const fs::path& folder) {
  const fs::path normal = folder.lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

// The folders that runs are given in, by their names.
using GivenFolders = std::map<std::string, std::set<fs::path>>;

GivenFolders CollectFolders(const std::vector<RunToEvaluate>& runs) {
  GivenFolders folders;
  for (const RunToEvaluate& run : runs) {
    if (!run.within.empty()) folders[Normal(run.within).filename().string()].insert(Normal(run.within));
  }
  return folders;
}

// The folder's name where it tells the variants apart, else its path.
std::string NameVariant(const RunToEvaluate& run, const GivenFolders& folders) {
  if (run.within.empty()) return run.name;
  const fs::path folder = Normal(run.within);
  return folders.at(folder.filename().string()).size() == 1 ? folder.filename().string() : folder.string();
}

void AddRoom(const std::string& name, EvaluatedRoom room, std::vector<RoomVariant>& variants) {
  auto variant = std::find_if(variants.begin(), variants.end(),
                              [&](const RoomVariant& known) { return known.name == name; });
  if (variant == variants.end()) variant = variants.insert(variant, {name, {}});
  if (const EvaluatedRoom* other = FindRoom(*variant, room.room)) {
    throw InputError(fmt::format("{} and {}: are two runs '{}' of room '{}'; give folders of other names",
                                 other->folder.string(), room.folder.string(), name, room.room));
  }
  variant->rooms.push_back(std::move(room));
}

}  // namespace

int EvaluatedRoom::found() const {
  return static_cast<int>(std::count_if(
      objects.begin(), objects.end(), [](const RoomObject& object) { return object.of.error.has_value(); }));
}

std::optional<double> EvaluatedRoom::mean_error_m() const {
  if (found() == 0) return std::nullopt;
  double sum = 0;
  for (const RoomObject& object : objects) sum += object.of.error ? object.of.error->centre_m : 0;
  return sum / found();
}

EvaluatedRoom EvaluateRoom(const RunToEvaluate& run, const SequenceTruth& truth,
                           const std::vector<CategoryModel>& models, const ObjectEvaluationOptions& options) {
  const RunResults results = LoadRun(run.run.folder);
  EvaluatedRoom room{.room = run.run.sequence, .folder = run.run.folder, .jitter = run.run.jitter};
  AddObjects(EvaluateRunObjects(results, truth, CollectSpecs(models), options), truth.truth.objects,
             DescribeObjectsFor(results, truth, models), room);
  EvaluateCameras(run.run.folder, truth.truth.T_world_camera, options, room);
  room.circumstances = DescribeRoom(truth, run.truth);
  if (!results.detections.empty()) room.circumstances.detections = "given";
  return room;
}

std::vector<RoomVariant> EvaluateRooms(const std::vector<RunToEvaluate>& runs,
                                       const std::vector<CategoryModel>& models,
                                       const ObjectEvaluationOptions& options) {
  std::vector<RoomVariant> variants;
  const GivenFolders folders = CollectFolders(runs);
  std::map<fs::path, RoomTruth> truths;  // by folder: those of substituted sequences differ
  for (const RunToEvaluate& run : runs) {
    ThrowIfInterrupted();
    const fs::path folder = Normal(run.truth);
    auto truth = truths.find(folder);
    if (truth == truths.end()) truth = truths.emplace(folder, LoadRoom(run, models)).first;
    const auto& [sequence, of_room] = truth->second;
    AddRoom(NameVariant(run, folders), EvaluateRoom(run, sequence, of_room, options), variants);
  }
  for (RoomVariant& variant : variants) {
    std::sort(variant.rooms.begin(), variant.rooms.end(),
              [](const EvaluatedRoom& a, const EvaluatedRoom& b) { return a.room < b.room; });
  }
  return variants;
}

const EvaluatedRoom* FindRoom(const RoomVariant& variant, const std::string& room) {
  const auto found = std::find_if(variant.rooms.begin(), variant.rooms.end(),
                                  [&](const EvaluatedRoom& known) { return known.room == room; });
  return found == variant.rooms.end() ? nullptr : &*found;
}

}  // namespace armature
