// SPDX-License-Identifier: BSD-3-Clause
// A room that is being drawn: the scene with what its file will say.
#pragma once

#include <string>
#include <vector>

#include "datasets/scene/scene.h"
#include "datasets/scene/solid.h"

namespace armature {

// As a scene file has it.
struct Placement {
  Eigen::Vector2d position{0, 0};  // metres; on a table: x and z of its frame
  double yaw_deg = 0;
  std::string on;  // id of an object; empty: the floor
  int group = 0;   // what was placed together
};

struct DrawnRoom {
  Scene scene;
  std::vector<Placement> objects, clutter;  // of the scene's
  std::vector<Eigen::Vector3d> clutter_sizes;
  std::vector<Solid> solids;  // objects' and then clutter's, in the order in which they were placed
  std::vector<int> groups;    // of the solids
  std::string sections;       // effects, odometry and detections, as text
};

}  // namespace armature
