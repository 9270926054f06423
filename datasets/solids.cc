// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/solids.h"

#include <algorithm>

namespace armature {

std::vector<Polygon> Sides(const Cuboid& cuboid, const Eigen::Isometry3d& T_world_parent, int object) {
  const Eigen::Isometry3d T_world_cuboid = T_world_parent * cuboid.T_parent_cuboid;
  std::vector<Polygon> sides;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Polygon side;
      side.object = object;
      side.colour = cuboid.colour;
      side.normal = sign * T_world_cuboid.linear().col(axis);
      for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        Eigen::Vector3d corner;
        corner[axis] = 0.5 * sign * cuboid.size[axis];
        corner[(axis + 1) % 3] = u * cuboid.size[(axis + 1) % 3];
        corner[(axis + 2) % 3] = v * cuboid.size[(axis + 2) % 3];
        side.corners.push_back(T_world_cuboid * corner);
      }
      sides.push_back(side);
    }
  }
  return sides;
}

Eigen::AlignedBox3d BoundingBox(const std::vector<Cuboid>& cuboids) {
  Eigen::AlignedBox3d box;
  for (const Cuboid& cuboid : cuboids) {
    for (const Polygon& side : Sides(cuboid, Eigen::Isometry3d::Identity(), 0)) {
      for (const Eigen::Vector3d& corner : side.corners) box.extend(corner);
    }
  }
  return box;
}

bool Blocks(const Cuboid& cuboid, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Isometry3d T_cuboid_parent = cuboid.T_parent_cuboid.inverse();
  const Eigen::Vector3d start = T_cuboid_parent * a;
  const Eigen::Vector3d along = T_cuboid_parent * b - start;
  double first = 0, last = 1;  // part of the segment between the pairs of sides so far
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * cuboid.size[axis];
    if (along[axis] == 0) {
      if (std::abs(start[axis]) > half) return false;
      continue;
    }
    const double at_low = (-half - start[axis]) / along[axis], at_high = (half - start[axis]) / along[axis];
    first = std::max(first, std::min(at_low, at_high));
    last = std::min(last, std::max(at_low, at_high));
  }
  return first <= last;
}

}  // namespace armature
