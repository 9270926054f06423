// SPDX-License-Identifier: BSD-3-Clause
// What the map keeps of each frame.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "association/object_view.h"
#include "resection/line_resection.h"

namespace armature {

struct MapObservation {
  ObjectView view;         // without memory, floor and occluders; without model: repeats another detection
  int track = -1;          // what the front end takes it to be the continuation of; -1: it was not sure of it
  bool is_joined = false;  // the map found it to be of that track, however long that was out of sight
  PoseAndShape measured;   // what this image alone says
  ImageEvidence evidence;  // of lines and box, about `measured`
};

// A detection that no object's pose is learnt from.
struct SeenBox {
  const CategoryModel* model = nullptr;  // none: repeats another detection
  Box box;                               // pixels
  int track = -1;                        // as an observation's
};

// A frame from a place that others are kept of (keyframes.h): it has a camera and objects in the map, but
// says nothing of where they are.
struct PassedFrame {
  double timestamp = 0;                                             // seconds
  Eigen::Isometry3d T_odom_camera = Eigen::Isometry3d::Identity();  // the odometry's unit
  const Camera* camera = nullptr;                                   // none without detections
  std::vector<SeenBox> boxes;                                       // one a detection, in their order
};

struct MapFrame {
  double timestamp = 0;                                             // seconds
  Eigen::Isometry3d T_odom_camera = Eigen::Isometry3d::Identity();  // the odometry's unit
  bool follows_jump = false;                 // the odometry does not tell how the camera came here
  Eigen::Vector3d up_camera{0, -1, 0};       // unit
  double up_sigma = 1;                       // radians; 0: given by the sequence
  std::optional<FloorPrior> camera_height;   // above the floor, where it is known
  std::vector<MapObservation> observations;  // one a detection, in their order
  std::vector<PassedFrame> passed;           // since the frame before this one, by time
};

inline PassedFrame WithoutEvidence(const MapFrame& frame) {
  PassedFrame passed{frame.timestamp, frame.T_odom_camera, nullptr, {}};
  for (const MapObservation& observation : frame.observations) {
    passed.camera = observation.view.camera;
    passed.boxes.push_back({observation.view.model, observation.view.detection.box, observation.track});
  }
  return passed;
}

// The paper's phi: which object each observation of each frame is of; -1: of none that is known.
using ObjectOfObservation = std::vector<std::vector<int>>;

}  // namespace armature
