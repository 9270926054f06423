// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/top_down_map.h"

#include <fmt/format.h>

#include <algorithm>

namespace armature {
namespace {

using ToPage = Eigen::Matrix<double, 2, 3>;

constexpr size_t kMostPathPoints = 600;  // of a drawn trajectory
constexpr double kVertical = 0.1;        // a horizontal part below which an axis is no direction on the page

std::vector<Eigen::Vector2d> PathOnPage(const std::vector<TimedPose>& cameras, const ToPage& to_page) {
  const size_t step = std::max<size_t>(1, (cameras.size() + kMostPathPoints - 1) / kMostPathPoints);
  std::vector<Eigen::Vector2d> path;
  for (size_t i = 0; i < cameras.size(); i += step) path.push_back(to_page * cameras[i].pose.translation());
  if (!cameras.empty() && (cameras.size() - 1) % step != 0)
    path.push_back(to_page * cameras.back().pose.translation());
  return path;
}

MapLayer::Object ObjectOnPage(const std::string& id, const std::string& category,
                              const Eigen::Isometry3d& T_world_object, const Eigen::Vector3d& size,
                              const ToPage& to_page) {
  MapLayer::Object object;
  object.id = id;
  object.category = category;
  constexpr std::array<std::array<double, 2>, 4> kSigns{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d corner(kSigns[i][0] * size.x() / 2, 0, kSigns[i][1] * size.z() / 2);
    object.footprint[i] = to_page * (T_world_object * corner);
  }
  const Eigen::Vector2d front = to_page * T_world_object.linear().col(2);
  if (front.norm() > kVertical) object.front = front.normalized();
  return object;
}

std::optional<double> FindError(const ShownMap& map, const std::string& id) {
  for (const EvaluatedObject& object : map.evaluated) {
    if (object.map_id == id && object.error) return object.error->centre_m;
  }
  return std::nullopt;
}

MapLayer MakeLayer(const std::string& name, const ShownMap& map, const ToPage& to_page) {
  MapLayer layer{name, PathOnPage(map.T_world_camera, to_page), {}};
  for (const PlacedObject& object : map.objects) {
    layer.objects.push_back(
        ObjectOnPage(object.id, object.category, object.T_world_object, object.size, to_page));
    layer.objects.back().error_m = FindError(map, object.id);
  }
  return layer;
}

MapLayer TrueLayer(const GroundTruth& truth, const ToPage& to_page) {
  MapLayer layer{"truth", PathOnPage(truth.T_world_camera, to_page), {}};
  for (const TrueObject& object : truth.objects) {
    layer.objects.push_back(
        ObjectOnPage(object.id, object.category, object.T_world_object, object.size, to_page));
  }
  return layer;
}

// The runs in the order in which their maps are shown.
std::vector<const LoadedRun*> Ordered(const std::vector<LoadedRun>& runs) {
  std::vector<const LoadedRun*> ordered;
  for (const LoadedRun& run : runs) ordered.push_back(&run);
  const auto open = std::find_if(ordered.begin() + 1, ordered.end(), [](const LoadedRun* run) {
    return run->map && run->configuration.loop_closure == std::optional<bool>(false);
  });
  if (open != ordered.end()) std::rotate(ordered.begin() + 1, open, open + 1);
  return ordered;
}

}  // namespace

ToPage PageFromWorld(const Eigen::Vector3d& up) {
  const auto horizontal = [&](const Eigen::Vector3d& axis) { return axis - up * up.dot(axis); };
  Eigen::Vector3d right = horizontal(Eigen::Vector3d::UnitX());
  if (right.norm() < kVertical) right = horizontal(Eigen::Vector3d::UnitZ());
  right.normalize();
  ToPage to_page;
  to_page << right.transpose(), up.cross(right).transpose();
  return to_page;
}

std::optional<TopDownMap> MakeTopDownMap(const SequenceRuns& sequence) {
  const ToPage to_page = PageFromWorld(sequence.up);
  TopDownMap map;
  map.sequence = sequence.name;
  for (const LoadedRun* run : Ordered(sequence.runs)) {
    if (run->map)
      map.estimates.push_back(
          MakeLayer(fmt::format("{}: {}", run->name, ApproachTitle(run->map->approach)), *run->map, to_page));
  }
  if (map.estimates.empty()) return std::nullopt;
  if (const LoadedRun& first = sequence.runs.front(); first.odometry) {
    const auto others =
        std::find_if(map.estimates.begin() + 1, map.estimates.end(),
                     [](const MapLayer& layer) { return !layer.name.ends_with("no loop closure"); });
    map.estimates.insert(others, MakeLayer("odometry only", *first.odometry, to_page));
  }
  if (sequence.truth) map.truth = TrueLayer(sequence.truth->truth, to_page);
  map.note = sequence.truth
                 ? "Each map is moved so that its first camera is the true one; its scale is its own."
                 : "Without truth: each map as it is, seen along its own vertical.";
  return map;
}

}  // namespace armature
