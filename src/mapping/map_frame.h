// SPDX-License-Identifier: BSD-3-Clause
// What the map keeps of each frame.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "association/object_view.h"
#include "resection/line_resection.h"

namespace armature {

struct MapObservation {
  ObjectView view;         // without memory, floor and occluders
  int track = -1;          // what the front end takes it to be the continuation of; -1: it was not sure of it
  PoseAndShape measured;   // what this image alone says
  ImageEvidence evidence;  // of lines and box, about `measured`
};

struct MapFrame {
  double timestamp = 0;                                             // seconds
  Eigen::Isometry3d T_odom_camera = Eigen::Isometry3d::Identity();  // the odometry's unit
  Eigen::Vector3d up_camera{0, -1, 0};                              // unit
  double up_sigma = 1;                                              // radians; 0: given by the sequence
  std::vector<MapObservation> observations;                         // one a detection, in their order
};

// The paper's phi: which object each observation of each frame is of; -1: of none that is known.
using ObjectOfObservation = std::vector<std::vector<int>>;

}  // namespace armature
