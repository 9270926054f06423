// SPDX-License-Identifier: BSD-3-Clause
// Where things take up space: whether two of them collide.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "drawing/mesh.h"
#include "geometry/oriented_box.h"

namespace armature {

// What a placed mesh fills: the boxes around its parts, so that a chair may stand with its seat under a
// table.
struct Solid {
  OrientedBox around;              // everything; its axes are the mesh's
  std::vector<OrientedBox> parts;  // each along the axes of the part's own frame
};

Solid MakeSolid(const Mesh& mesh, const Eigen::Isometry3d& T_world_mesh);

// Whether parts of the two have more than 1 cm^3 in common: things that stand on each other only touch.
bool Overlap(const Solid& a, const Solid& b);

// Whether the point is inside of the box or nearer than `clearance` to it (measured along its axes), metres.
bool IsNear(const OrientedBox& box, const Eigen::Vector3d& point, double clearance);

// World frame.
std::vector<Eigen::Vector3d> Corners(const OrientedBox& box);

}  // namespace armature
