// SPDX-License-Identifier: BSD-3-Clause
// How much two boxes in space have in common.
#pragma once

#include <Eigen/Geometry>

namespace armature {

// The box of all points T_world_box * x with |x_i| <= size_i / 2.
struct OrientedBox {
  Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();  // metres
  Eigen::Vector3d size{0, 0, 0};                                  // metres, at least 0

  double volume() const { return size.prod(); }  // cubic metres
};

// Cubic metres, exact up to rounding: one box is clipped by the other's six planes.
double IntersectionVolume(const OrientedBox& a, const OrientedBox& b);

// The common volume over that of both together, 0..1; 0 where neither has any.
double IntersectionOverUnion(const OrientedBox& a, const OrientedBox& b);

}  // namespace armature
