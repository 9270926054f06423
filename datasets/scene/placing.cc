// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/placing.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/support.h"
#include "geometry/rotation.h"

namespace armature {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

namespace {

constexpr double kTouching = 1e-6;  // metres, of rounding

SceneObject ReadSupport(const YamlMap& map, const std::vector<SceneObject>& objects) {
  const std::string id = map.Text("on");
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [&](const SceneObject& object) { return object.id == id; });
  if (found == objects.end()) {
    std::vector<std::string> known;
    known.reserve(objects.size());
    for (const SceneObject& object : objects) known.push_back(object.id);
    throw InputError(fmt::format("{}: {} (only objects listed before it count)", map.Where("on"),
                                 UnknownNameMessage("object", id, known)));
  }
  if (!IsSupport(*found)) {
    throw InputError(
        map.At("on", fmt::format("is {}, a {}; only tables and seats carry something, name one or "
                                 "leave the key out",
                                 Quoted(id), found->instance.category)));
  }
  return *found;
}

// Whether all corners are within the size around the frame's origin, along its x and y.
bool IsWithin(const OrientedBox& box, const Isometry3d& T_world_frame, const Eigen::Vector2d& size) {
  const Isometry3d T_frame_world = T_world_frame.inverse();
  const std::vector<Vector3d> corners = Corners(box);
  return std::all_of(corners.begin(), corners.end(), [&](const Vector3d& corner) {
    const Eigen::Vector2d at = (T_frame_world * corner).head<2>();
    return (at.cwiseAbs() - 0.5 * size).maxCoeff() < kTouching;
  });
}

void CheckEdges(const YamlMap& map, const SceneObject& support, const NamedSolid& solid) {
  const Eigen::Vector2d top(support.instance.size.x(), support.instance.size.z());
  if (IsWithin(solid.solid.around, FindTop(support), top)) return;
  throw InputError(
      map.At("position", fmt::format("lets {} stick out over the edge of {}, whose top is {:.2f} "
                                     "x {:.2f} m; move it inwards or turn it",
                                     solid.name, support.id, top.x(), top.y())));
}

void CheckRoom(const YamlMap& map, const Room& room, const NamedSolid& solid) {
  const OrientedBox& box = solid.solid.around;
  double top = 0;
  for (const Vector3d& corner : Corners(box)) top = std::max(top, corner.z());
  if (IsWithin(box, Isometry3d::Identity(), room.size.head<2>()) && top < room.size.z()) return;
  throw InputError(map.At("position", fmt::format("lets {} reach out of the room of {} x {} x {} m around "
                                                  "[0, 0]; move it inwards",
                                                  solid.name, room.size.x(), room.size.y(), room.size.z())));
}

}  // namespace

std::vector<NamedSolid> MakeSolids(const std::vector<SceneObject>& objects) {
  std::vector<NamedSolid> solids;
  solids.reserve(objects.size());
  for (const SceneObject& object : objects) {
    solids.push_back({object.id, MakeSolid(object.instance.mesh, object.T_world_object)});
  }
  return solids;
}

Place ReadPlace(const YamlMap& map, const std::vector<SceneObject>& objects) {
  const Eigen::Vector2d position = ReadPair(map, "position");
  const double yaw = map.Has("yaw_deg") ? map.Number("yaw_deg") * kDegree : 0;
  const Eigen::AngleAxisd turned(yaw, Vector3d::UnitZ());
  if (!map.Has("on")) return {Translation3d(position.x(), position.y(), 0) * turned, std::nullopt};
  const SceneObject support = ReadSupport(map, objects);
  return {FindTop(support) * Translation3d(position.x(), -position.y(), 0) * turned, support};
}

void CheckFree(const YamlMap& map, const Place& place, const NamedSolid& solid, const Room& room,
               const std::vector<NamedSolid>& others) {
  CheckRoom(map, room, solid);
  if (place.support) CheckEdges(map, *place.support, solid);
  for (const NamedSolid& other : others) {
    if (!Overlap(solid.solid, other.solid)) continue;
    throw InputError(map.At(
        "position", fmt::format("lets {} overlap {}; move or turn one of them", solid.name, other.name)));
  }
}

}  // namespace armature
