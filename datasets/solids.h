// SPDX-License-Identifier: BSD-3-Clause
// What is drawn: boxes, and flat, convex polygons.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace armature {

using Colour = Eigen::Vector3d;  // red, green, blue, 0..1

struct Cuboid {
  Eigen::Isometry3d T_parent_cuboid =
      Eigen::Isometry3d::Identity();  // metres; its origin is the cuboid's centre
  Eigen::Vector3d size{1, 1, 1};      // metres, along its axes
  Colour colour{0.5, 0.5, 0.5};
};

struct Polygon {
  std::vector<Eigen::Vector3d> corners;  // metres, world; convex, flat, seen from the side of the normal only
  Eigen::Vector3d normal{0, 0, 1};       // unit, world
  Colour colour{0.5, 0.5, 0.5};
  int object = 0;  // 0: the room, otherwise the number of the piece of furniture
};

// The six sides, given where the cuboid's parent stands.
std::vector<Polygon> Sides(const Cuboid& cuboid, const Eigen::Isometry3d& T_world_parent, int object);

// Size of the box around the cuboids along the axes of their parent, and its centre.
Eigen::AlignedBox3d BoundingBox(const std::vector<Cuboid>& cuboids);

// Whether the segment from a to b (parent's frame) meets the cuboid.
bool Blocks(const Cuboid& cuboid, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace armature
