// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/circumstances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/statistics.h"
#include "category/category_lookup.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

constexpr double kRadiansToDegrees = 180 / std::numbers::pi;

using Views = std::vector<TimedPose>;  // T_world_camera

bool IsInImage(const Camera& camera, const Eigen::Vector3d& point_camera) {
  if (point_camera.z() <= 0) return false;
  const Eigen::Vector2d pixel = camera.Project(point_camera);
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < camera.width && pixel.y() < camera.height;
}

bool IsWhole(const Camera& camera, const Eigen::Isometry3d& T_camera_object, const Eigen::Vector3d& size) {
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    if (!IsInImage(camera, T_camera_object * size.cwiseProduct(sign))) return false;
  }
  return true;
}

Views FindViews(const SequenceTruth& sequence, size_t object) {
  const GroundTruth& truth = sequence.truth;
  const Eigen::Vector3d centre = truth.objects[object].T_world_object.translation();
  Views views;
  if (truth.knows_detections) {
    for (const auto& [key, detected] : truth.detections) {
      const auto camera = FindStamp(truth.T_world_camera, static_cast<double>(key.first) / 1e6);
      if (detected == object && camera) views.push_back(truth.T_world_camera[*camera]);
    }
    return views;
  }
  for (const TimedPose& camera : truth.T_world_camera) {
    if (IsInImage(sequence.camera, camera.pose.inverse() * centre)) views.push_back(camera);
  }
  return views;
}

std::optional<double> MedianOf(const std::vector<double>& values) { return Quantile(values, 0.5); }

std::optional<double> Parallax(const std::vector<Eigen::Vector3d>& rays) {
  if (rays.empty()) return std::nullopt;
  double least = 1;
  for (size_t i = 0; i < rays.size(); ++i) {
    for (size_t j = 0; j < i; ++j) least = std::min(least, rays[i].dot(rays[j]));
  }
  return std::acos(std::max(least, -1.0)) * kRadiansToDegrees;
}

std::optional<double> HiddenShare(const SequenceTruth& sequence, size_t object, const Views& views) {
  if (!sequence.edges) return std::nullopt;
  double visible = 0, length = 0;
  for (const TimedPose& view : views) {
    for (const VisibleEdge& edge : sequence.edges->Seen(object, view.timestamp, 1)) {
      if (!edge.in_image) continue;
      visible += edge.visible_length();
      length += static_cast<double>(edge.samples.size());
    }
  }
  if (length <= 0) return std::nullopt;
  return 1 - visible / length;
}

double SizeDeviation(const TrueObject& object, const CategoryModel& model) {
  const Eigen::Vector3d mean = BoundingBoxSize(WireframeFromVector(model.mean)) + 2 * model.spec.padding;
  return (object.size.array() / mean.array()).log().abs().mean();
}

ObjectCircumstances DescribeObject(const SequenceTruth& sequence, size_t index, const CategoryModel& model) {
  const TrueObject& object = sequence.truth.objects[index];
  const Views views = FindViews(sequence, index);
  ObjectCircumstances found{.views = static_cast<int>(views.size())};
  std::vector<double> distances;
  std::vector<Eigen::Vector3d> rays;
  for (const TimedPose& view : views) {
    const Eigen::Vector3d ray = object.T_world_object.translation() - view.pose.translation();
    distances.push_back(ray.norm());
    rays.push_back(ray.normalized());
    if (!found.was_whole)
      found.was_whole = IsWhole(sequence.camera, view.pose.inverse() * object.T_world_object, object.size);
  }
  found.distance_m = MedianOf(distances);
  found.parallax_deg = Parallax(rays);
  found.hidden_share = HiddenShare(sequence, index, views);
  found.size_deviation = SizeDeviation(object, model);
  return found;
}

// Against gravity: the mean of the objects' own.
std::optional<Eigen::Vector3d> FindTrueUp(const std::vector<TrueObject>& objects) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const TrueObject& object : objects) sum += object.T_world_object.linear().col(1);
  if (sum.norm() < 1e-9) return std::nullopt;
  return sum.normalized();
}

double LowestBase(const std::vector<TrueObject>& objects, const Eigen::Vector3d& up) {
  double lowest = std::numeric_limits<double>::max();
  for (const TrueObject& object : objects)
    lowest = std::min(lowest, up.dot(object.T_world_object.translation()) - object.size.y() / 2);
  return lowest;
}

std::string ReadDetectionSetting(const YamlMap& map) {
  if (!map.Has("detections")) return "simulated";
  if (!map.IsMap("detections")) return map.Text("detections");
  const YamlMap detections = map.Map("detections");
  return detections.Has("setting") ? detections.Text("setting") : "simulated";
}

std::string ReadPathKind(const YamlMap& map) {
  const YamlMap path = map.MapOrEmpty("path");
  return path.Has("kind") ? path.Text("kind") : "";
}

}  // namespace

std::vector<ObjectCircumstances> DescribeObjects(const SequenceTruth& sequence,
                                                 const std::vector<CategoryModel>& models) {
  std::vector<ObjectCircumstances> all;
  for (size_t i = 0; i < sequence.truth.objects.size(); ++i)
    all.push_back(DescribeObject(sequence, i, LookUpModel(models, sequence.truth.objects[i].category)));
  return all;
}

RoomCircumstances DescribeRoom(const SequenceTruth& sequence, const std::filesystem::path& folder) {
  const std::vector<TimedPose>& cameras = sequence.truth.T_world_camera;
  RoomCircumstances room{.images = static_cast<long>(cameras.size()),
                         .objects = static_cast<long>(sequence.truth.objects.size())};
  if (const auto scene = folder / "scene.yaml"; std::filesystem::exists(scene)) {
    const YamlMap map = YamlMap::Load(scene);
    room.detections = ReadDetectionSetting(map);
    room.path = ReadPathKind(map);
  }
  for (size_t i = 1; i < cameras.size(); ++i)
    room.path_m += (cameras[i].pose.translation() - cameras[i - 1].pose.translation()).norm();
  const std::optional<Eigen::Vector3d> up = FindTrueUp(sequence.truth.objects);
  if (!up) return room;
  const double floor = LowestBase(sequence.truth.objects, *up);
  std::vector<double> pitches, heights;
  for (const TimedPose& camera : cameras) {
    const double sine = std::clamp(-up->dot(camera.pose.linear().col(2)), -1.0, 1.0);
    pitches.push_back(std::asin(sine) * kRadiansToDegrees);
    heights.push_back(up->dot(camera.pose.translation()) - floor);
  }
  room.pitch_deg = MedianOf(pitches);
  room.camera_height_m = MedianOf(heights);
  return room;
}

}  // namespace armature
