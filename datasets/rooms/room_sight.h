// SPDX-License-Identifier: BSD-3-Clause
// What a camera sees of a room's objects on its way, found by a few rays.
#pragma once

#include <vector>

#include "datasets/scene/scene.h"
#include "drawing/ray_scene.h"

namespace armature {

class RoomSight {
 public:
  explicit RoomSight(const Scene& scene);  // its objects and its clutter

  // For each object and each pose whether a third of it is seen from there, at most 7 m away.
  std::vector<std::vector<bool>> FindViews(const std::vector<Eigen::Isometry3d>& T_world_camera) const;

 private:
  bool IsSeen(size_t object, const Eigen::Isometry3d& T_world_camera) const;

  const Scene& scene_;
  RayScene rays_;
};

}  // namespace armature
