// SPDX-License-Identifier: BSD-3-Clause
// The four walls, and what hangs on them.
#pragma once

#include <array>

#include "datasets/scene/scene.h"
#include "drawing/mesh.h"
#include "geometry/random.h"

namespace armature {

struct Wall {
  // x to the right for somebody who faces the wall, y up, z into the room; its origin is in the middle of the
  // wall's lower edge.
  Eigen::Isometry3d T_world_wall = Eigen::Isometry3d::Identity();
  double width = 0;   // metres
  double height = 0;  // metres
};

// Those at the room's +y, -x, -y, +x.
std::array<Wall, 4> MakeWalls(const Room& room);

// A single sheet in the x-y plane of its frame, seen from its +z; x and y sizes.
Part Sheet(const Eigen::Isometry3d& T_mesh_sheet, const Eigen::Vector2d& size, const Material& material);

// A door, a window where a wall is left for it, and the room's pictures as far as there is space; world
// frame.
Mesh WallDecoration(const Room& room, Random& random);

}  // namespace armature
