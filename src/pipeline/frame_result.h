// SPDX-License-Identifier: BSD-3-Clause
// What the pipeline hands out for each frame.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "association/object_view.h"
#include "geometry/segment.h"
#include "resection/object_estimate.h"

namespace armature {

struct StageTimes {         // milliseconds, wall clock
  double load = 0;          // reading and decoding the image; outside the total
  double lines = 0;         // line detection, one pass for all objects
  double association = 0;   // hypotheses and their costs, all objects
  double optimization = 0;  // resection, all objects
  double mapping = 0;       // what is kept between frames: up direction, floor, tracks, the map
  double total() const { return lines + association + optimization + mapping; }
};

struct ObjectObservation {
  Detection detection;
  Eigen::Isometry3d T_camera_object_initial =
      Eigen::Isometry3d::Identity();  // before resection, for pictures
  Eigen::VectorXd coefficients_initial;
  ObjectEstimate estimate;
};

struct FrameResult {
  double timestamp = 0;                         // seconds
  std::vector<Segment> segments;                // undistorted pixels
  std::vector<ObjectObservation> observations;  // in the order of the detections
  Eigen::Vector3d up_camera{0, -1, 0};          // unit, camera frame
  double up_sigma = 1;                          // radians, standard deviation; 0: given by the sequence
  bool follows_jump = false;        // the odometry's step to this frame was not believed (odometry_jumps.h)
  bool unit_changed = false;        // the odometry was found to go on in another unit since shortly before
  std::optional<FloorPrior> floor;  // what was assumed of the camera's height for this frame
  StageTimes times;
};

}  // namespace armature
