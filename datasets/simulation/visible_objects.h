// SPDX-License-Identifier: BSD-3-Clause
// What is seen of each object in a picture.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "drawing/ray_scene.h"
#include "geometry/box.h"
#include "geometry/camera.h"

namespace armature {

struct VisibleObject {
  int object = 0;            // its number in the scene, from 1
  Box box;                   // around its visible pixels
  double visible_share = 0;  // of what would be seen if nothing hid it and the picture had no border, 0..1
};

// `objects`: the number of the object that each pixel sees. Objects of which no pixel is seen are left out;
// in the order of their numbers. The share is found by rays, about 400 an object, in a picture three times as
// wide and high.
std::vector<VisibleObject> VisibleObjects(const RayScene& rays, const cv::Mat1i& objects,
                                          const Camera& camera, const Eigen::Isometry3d& T_world_camera);

// Around the object's corners where the picture would show them; all of `within` when a part of it is behind
// the camera, and at most that.
Box ProjectedExtent(const std::vector<PlacedMesh>& meshes, int object, const Camera& camera,
                    const Eigen::Isometry3d& T_camera_world, const Box& within);

}  // namespace armature
