// SPDX-License-Identifier: BSD-3-Clause
// Small scenes of the renderer's tests.
#pragma once

#include <Eigen/Geometry>

#include "datasets/cad/solids.h"
#include "drawing/ray_scene.h"
#include "geometry/camera.h"

namespace armature::testing {

// A plain square of side 2 around the origin in the x-y plane, seen from above; corner 0 at (-1, -1),
// corner 1 at (1, -1).
inline Part Square(const Colour& colour = {0.5, 0.5, 0.5}) {
  Part part;
  part.material.colour = colour;
  part.quads.push_back({{Eigen::Vector3d(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
  return part;
}

inline PlacedMesh Placed(const Part& part, const Eigen::Vector3d& position, int object = kRoom) {
  PlacedMesh placed{{{part}}, Eigen::Isometry3d::Identity(), object};
  placed.T_world_mesh.translation() = position;
  return placed;
}

// At `position`, looking straight down: the picture's right is the world's x, its top the world's y.
inline Eigen::Isometry3d LookingDown(const Eigen::Vector3d& position) {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  T_world_camera.translation() = position;
  return T_world_camera;
}

inline Camera SmallCamera() { return {40, 40, 20, 20, 19.5, 19.5, {}}; }

}  // namespace armature::testing
