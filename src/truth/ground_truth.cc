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

std::vector<TrueObject> ReadObjects(const std::filesystem::path& file) {
  const CsvTable table(file, {"id", "category", "instance", "tx", "ty", "tz", "qx", "qy", "qz", "qw",
                              "size_x", "size_y", "size_z"});
  std::vector<TrueObject> objects;
  for (const CsvRow& row : table.rows()) {
    TrueObject object{row.Text("id"), row.Text("category"), row.Text("instance")};
    object.T_world_object = ReadPose(row);
    object.size = Eigen::Vector3d(row.Number("size_x"), row.Number("size_y"), row.Number("size_z"));
    objects.push_back(std::move(object));
  }
  return objects;
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
  const CsvTable table(sequence / "detections_gt.csv", {"timestamp", "index", "id"});
  for (const CsvRow& row : table.rows()) {
    const std::pair<long long, int> detection{Microseconds(row.Number("timestamp")), row.Integer("index")};
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
