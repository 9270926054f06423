// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/free_floor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kWalking = 0.25;  // metres
constexpr double kFlying = 0.2;    // metres
constexpr double kStride = 0.1;    // metres between the places that are looked at

}  // namespace

bool FreeFloor::IsFree(const Vector2d& position) const {
  if ((position.cwiseAbs() - 0.5 * room_.scene.room.size.head<2>()).maxCoeff() > -kWalking) return false;
  return std::none_of(room_.solids.begin(), room_.solids.end(), [&](const Solid& solid) {
    const double level = solid.around.T_world_box.translation().z();
    return IsNear(solid.around, {position.x(), position.y(), level}, kWalking);
  });
}

bool FreeFloor::IsFree(const Vector2d& from, const Vector2d& to) const {
  const int count = 1 + static_cast<int>((to - from).norm() / kStride);
  for (int i = 0; i <= count; ++i) {
    if (!IsFree(Vector2d(from + static_cast<double>(i) / count * (to - from)))) return false;
  }
  return true;
}

bool FreeFloor::IsClear(const Vector3d& camera) const {
  const Vector3d size = room_.scene.room.size;
  const Vector3d from_middle = camera - Vector3d(0, 0, 0.5 * size.z());
  if ((from_middle.cwiseAbs() - 0.5 * size).maxCoeff() > -kFlying) return false;
  return std::none_of(room_.solids.begin(), room_.solids.end(),
                      [&](const Solid& solid) { return IsNear(solid.around, camera, kFlying); });
}

Vector2d FreeFloor::Anywhere(Random& random) const {
  Vector2d position(0, 0);
  for (int i = 0; i < 100; ++i) {
    position = {random.Uniform(-0.5, 0.5) * room_.scene.room.size.x(),
                random.Uniform(-0.5, 0.5) * room_.scene.room.size.y()};
    if (IsFree(position)) break;
  }
  return position;
}

Outline::Outline(const DrawnRoom& room, size_t object, double distance) : distance_(distance) {
  const Placement& middle = room.objects[object];
  Eigen::Isometry2d T_world_object = Eigen::Isometry2d::Identity();
  const Eigen::Isometry3d& T = room.scene.objects[object].T_world_object;
  const Vector3d x = T.linear().col(0);
  T_world_object.translation() = T.translation().head<2>();
  T_world_object.linear() = Eigen::Rotation2Dd(std::atan2(x.y(), x.x())).toRotationMatrix();
  Eigen::AlignedBox2d around;
  for (size_t i = 0; i < room.solids.size(); ++i) {
    if (room.groups[i] != middle.group) continue;
    for (const Vector3d& corner : Corners(room.solids[i].around))
      around.extend(Vector2d(T_world_object.inverse() * Vector2d(corner.head<2>())));
  }
  half_ = 0.5 * around.sizes();
  T_world_middle_ = T_world_object * Eigen::Translation2d(around.center());
}

double Outline::length() const { return 4 * half_.sum() + 2 * pi * distance_; }

Vector2d Outline::At(double along) const {
  double rest = along - length() * std::floor(along / length());
  // A straight and the corner after it, four times: turned by a right angle each.
  for (int side = 0; side < 4; ++side) {
    const double half_long = side % 2 == 0 ? half_.x() : half_.y();
    const double half_deep = side % 2 == 0 ? half_.y() : half_.x();
    const Eigen::Rotation2Dd turned(side * pi / 2);
    if (rest < 2 * half_long)
      return T_world_middle_ * (turned * Vector2d(rest - half_long, -half_deep - distance_));
    rest -= 2 * half_long;
    const double corner = 0.5 * pi * distance_;
    if (rest < corner) {
      const double angle = rest / distance_ - pi / 2;
      return T_world_middle_ * (turned * (Vector2d(half_long, -half_deep) +
                                          distance_ * Vector2d(std::cos(angle), std::sin(angle))));
    }
    rest -= corner;
  }
  return T_world_middle_ * Vector2d(-half_.x(), -half_.y() - distance_);
}

Vector2d Outline::NearestInside(const Vector2d& position) const {
  const Vector2d at = T_world_middle_.inverse() * position;
  const Vector2d inner = (half_.array() - 0.2).max(0.0).matrix();
  return T_world_middle_ * Vector2d(at.cwiseMax(-inner).cwiseMin(inner));
}

}  // namespace armature
