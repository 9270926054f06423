// SPDX-License-Identifier: BSD-3-Clause
#include "truth/ground_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/errors.h"
#include "base/microseconds.h"
#include "base/text.h"
#include "io/csv.h"
#include "io/trajectory.h"

namespace armature {
namespace {

void CheckObject(const CsvRow& row, const TrueObject& object, const std::vector<TrueObject>& earlier) {
  if (object.id.empty()) throw InputError(row.At("the id is empty; name each object"));
  const auto same = std::find_if(earlier.begin(), earlier.end(),
                                 [&](const TrueObject& other) { return other.id == object.id; });
  if (same != earlier.end()) {
    throw InputError(
        row.At(fmt::format("object {} is already in line {}; keep one", Quoted(object.id), same->line)));
  }
  if (object.size.minCoeff() > 0) return;
  throw InputError(row.At(fmt::format("the size of {} is {:g} x {:g} x {:g}; metres, greater than 0",
                                      Quoted(object.id), object.size.x(), object.size.y(), object.size.z())));
}

std::vector<TrueObject> ReadObjects(const std::filesystem::path& file) {
  const CsvTable table(file, {"id", "category", "instance", "tx", "ty", "tz", "qx", "qy", "qz", "qw",
                              "size_x", "size_y", "size_z"});
  std::vector<TrueObject> objects;
  for (const CsvRow& row : table.rows()) {
    TrueObject object{row.Text("id"), row.Text("category"), row.Text("instance")};
    object.T_world_object = ReadPose(row);
    object.size = Eigen::Vector3d(row.Number("size_x"), row.Number("size_y"), row.Number("size_z"));
    object.line = row.line();
    CheckObject(row, object, objects);
    objects.push_back(std::move(object));
  }
  return objects;
}

// How many detections there are at each stamp, whole microseconds; nothing where the folder has only truth.
std::optional<std::map<long long, int>> CountDetections(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  std::map<long long, int> counts;
  const CsvTable table(file, {"timestamp"});
  for (const CsvRow& row : table.rows()) ++counts[Microseconds(row.Number("timestamp"))];
  return counts;
}

// Of rows that are within the tolerance of it.
int CountAt(const std::map<long long, int>& counts, double timestamp) {
  const long long at = Microseconds(timestamp), tolerance = Microseconds(kStampTolerance);
  int count = 0;
  for (auto it = counts.lower_bound(at - tolerance); it != counts.end() && it->first <= at + tolerance; ++it)
    count += it->second;
  return count;
}

// Rows of detections_gt.csv are of detections: one that counts from 1 would give all truth to others.
void CheckDetection(const CsvRow& row, const std::optional<std::map<long long, int>>& counts) {
  const int index = row.Integer("index");
  if (index < 0)
    throw InputError(row.At(fmt::format("index {} is less than 0; detections are counted from 0", index)));
  if (!counts) return;
  const int count = CountAt(*counts, row.Number("timestamp"));
  if (index < count) return;
  throw InputError(row.At(fmt::format(
      "index {}, but detections.csv has {} at stamp {:.6f}; count those of a stamp from 0, in its order",
      index, count == 1 ? "1 detection" : fmt::format("{} detections", count), row.Number("timestamp"))));
}

// The file's first line that is a comment, without the mark.
std::string FirstComment(const std::filesystem::path& file) {
  std::istringstream stream(ReadTextFile(file));
  for (std::string line; std::getline(stream, line);) {
    if (Trimmed(line).starts_with("#")) return Trimmed(Trimmed(line).substr(1));
  }
  return "";
}

}  // namespace

std::vector<TimedPose> LoadTrueTrajectory(const std::filesystem::path& sequence) {
  TrajectoryReading reading{.repeated = RepeatedStamps::kKept};
  if (std::filesystem::exists(sequence / "rgb.txt")) reading.stamps = ReadStamps(sequence / "rgb.txt");
  return ReadTrajectory(sequence / "groundtruth.txt", reading);
}

GroundTruth LoadGroundTruth(const std::filesystem::path& sequence) {
  GroundTruth truth;
  truth.T_world_camera = LoadTrueTrajectory(sequence);
  truth.objects = ReadObjects(sequence / "objects_gt.csv");
  truth.objects_source = FirstComment(sequence / "objects_gt.csv");
  const auto counts = CountDetections(sequence / "detections.csv");
  const CsvTable table(sequence / "detections_gt.csv", {"timestamp", "index", "id"});
  std::map<std::pair<long long, int>, int> lines;
  for (const CsvRow& row : table.rows()) {
    CheckDetection(row, counts);
    const std::pair<long long, int> detection{Microseconds(row.Number("timestamp")), row.Integer("index")};
    if (const auto [first, is_new] = lines.emplace(detection, row.line()); !is_new)
      throw InputError(row.At(fmt::format("this detection is already in line {}; keep one", first->second)));
    if (row.IsEmpty("id")) {
      truth.false_alarms.push_back(detection);
      continue;
    }
    const auto object = std::find_if(truth.objects.begin(), truth.objects.end(),
                                     [&](const TrueObject& o) { return o.id == row.Text("id"); });
    if (object == truth.objects.end()) {
      throw InputError(row.At(
          fmt::format("no object '{}' in objects_gt.csv; add it or leave the id empty", row.Text("id"))));
    }
    truth.detections[detection] = static_cast<size_t>(object - truth.objects.begin());
  }
  return truth;
}

GroundTruth TruthOfRun(GroundTruth truth, const RunResults& run) {
  if (run.detections.empty()) return truth;
  truth.detections.clear();
  truth.false_alarms.clear();
  truth.knows_detections = false;
  return truth;
}

const TrueObject* GroundTruth::FindObject(double timestamp, int index) const {
  const long long at = Microseconds(timestamp);
  const long long tolerance = Microseconds(kStampTolerance);
  for (auto it = detections.lower_bound({at - tolerance, 0});
       it != detections.end() && it->first.first <= at + tolerance; ++it) {
    if (it->first.second == index) return &objects[it->second];
  }
  return nullptr;
}

std::optional<Eigen::Isometry3d> GroundTruth::TrueCameraObject(double timestamp, int index) const {
  const TrueObject* object = FindObject(timestamp, index);
  const std::optional<size_t> camera = FindStamp(T_world_camera, timestamp);
  if (!object || !camera) return std::nullopt;
  return T_world_camera[*camera].pose.inverse() * object->T_world_object;
}

}  // namespace armature
