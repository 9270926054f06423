// SPDX-License-Identifier: BSD-3-Clause
// From where a map is looked at so that all of it is in the picture.
#pragma once

#include <Eigen/Geometry>

#include "drawing/map_scene.h"
#include "geometry/camera.h"

namespace armature {

// A rectangle on the floor; its frame has x to the picture's right, y away from the viewer, z up.
struct MapGround {
  Eigen::Isometry3d T_world_ground = Eigen::Isometry3d::Identity();  // metres, the origin on the floor
  Eigen::AlignedBox2d area;                                          // whole metres wide and deep
};

struct MapView {
  Camera camera;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  MapGround ground;
};

// Obliquely from above, along the horizontal direction in which the map is shallow, on the side from which
// its cameras look. The floor is where most objects that stand on it end; a map of nothing shows one square
// metre of floor.
MapView FrameMap(const MapScene& scene, int width, int height);

}  // namespace armature
