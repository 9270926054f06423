// SPDX-License-Identifier: BSD-3-Clause
// Stands in for an object detector and a viewpoint estimator.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "datasets/random.h"
#include "datasets/rasterizer.h"
#include "datasets/room.h"
#include "datasets/sequence_folder.h"

namespace armature {

// Boxes are those of the visible pixels, each side moved by 1 % of the box. Viewpoints are seen along the ray
// through the box's centre, off by 8, 4 and 3 degrees (azimuth, elevation, tilt); each 17th is turned by 180
// degrees, each 29th detection is missed.
class DetectionSimulator {
 public:
  explicit DetectionSimulator(std::uint64_t seed) : random_(seed) {}

  // What is found in the picture that `camera` takes; `surfaces` are of TwiceAsFine(camera). Pieces with few
  // visible pixels are not found.
  std::vector<GeneratedDetection> Detect(const VisibleSurfaces& surfaces,
                                         const std::vector<Polygon>& polygons,
                                         const std::vector<PlacedFurniture>& furniture, const Camera& camera,
                                         const Eigen::Isometry3d& T_world_camera);

 private:
  Box Noisy(const Box& box, const Camera& camera);
  void AddViewpoint(const Eigen::Matrix3d& R_camera_object, const Camera& camera, Detection* detection);

  Random random_;
  int candidates_ = 0;  // so far
};

}  // namespace armature
