// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/room_sight.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kFarthest = 7;        // metres
constexpr double kSeenShare = 1 / 3.;  // of the rays that would meet it

std::vector<PlacedMesh> Things(const Scene& scene) {
  std::vector<PlacedMesh> things;
  int number = kRoom;
  for (const SceneObject& object : scene.objects)
    things.push_back({object.instance.mesh, object.T_world_object, ++number});
  for (const ClutterPiece& piece : scene.clutter) things.push_back({piece.mesh, piece.T_world_mesh});
  return things;
}

// 27 places in a box of size 1 around the origin.
const std::vector<Vector3d>& PlacesInside() {
  static const std::vector<Vector3d> places = [] {
    std::vector<Vector3d> all;
    for (const double x : {-0.4, 0.0, 0.4}) {
      for (const double y : {-0.4, 0.0, 0.4}) {
        for (const double z : {-0.4, 0.0, 0.4}) all.emplace_back(x, y, z);
      }
    }
    return all;
  }();
  return places;
}

bool IsInPicture(const Camera& camera, const Vector3d& point_camera) {
  if (point_camera.z() < 0.05) return false;
  const Eigen::Vector2d pixel = camera.Project(point_camera);
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < camera.width && pixel.y() < camera.height;
}

}  // namespace

RoomSight::RoomSight(const Scene& scene) : scene_(scene), rays_(Things(scene)) {}

bool RoomSight::IsSeen(size_t object, const Eigen::Isometry3d& T_world_camera) const {
  const SceneObject& placed = scene_.objects[object];
  const Vector3d camera = T_world_camera.translation();
  if ((placed.T_world_object.translation() - camera).norm() > kFarthest) return false;
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  const int number = static_cast<int>(object) + 1;
  int all = 0, seen = 0;
  for (const Vector3d& place : PlacesInside()) {
    const Vector3d point = placed.T_world_object * place.cwiseProduct(placed.instance.size);
    const Vector3d direction = (point - camera).normalized();
    if (rays_.HitNearestOfObject(number, camera, direction).mesh < 0) continue;
    ++all;
    if (!IsInPicture(scene_.camera, T_camera_world * point)) continue;
    if (rays_.Nearest(camera, direction).object == number) ++seen;
  }
  return seen > kSeenShare * all;
}

std::vector<std::vector<bool>> RoomSight::FindViews(
    const std::vector<Eigen::Isometry3d>& T_world_camera) const {
  std::vector<std::vector<bool>> views(scene_.objects.size());
  for (size_t i = 0; i < views.size(); ++i) {
    for (const Eigen::Isometry3d& pose : T_world_camera) views[i].push_back(IsSeen(i, pose));
  }
  return views;
}

}  // namespace armature
