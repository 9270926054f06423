// SPDX-License-Identifier: BSD-3-Clause
// The odometry's pose at the stamps of the images, and what is missing of it.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "geometry/timed_pose.h"

namespace armature {

struct OdometryOptions {
  double tolerance = kStampTolerance;  // seconds: a pose this near to the image is the image's
  // Seconds between two neighbouring poses between which the camera may be interpolated. An acceleration of
  // a m/s^2 takes it off the straight way by at most a T^2 / 8: 8 mm at 1 m/s^2. Measured on hand-held video,
  // midway between poses 0.27 s apart: 5 mm and 0.4 degrees (median), 17 mm and 1.6 degrees (most).
  double max_gap = 0.25;
};

// How much of a sequence the odometry covers.
struct OdometryCoverage {
  int poses = 0;             // of the odometry
  int images = 0;            // of the sequence
  int images_with_pose = 0;  // with a pose of their own or an interpolated one
  int interpolated = 0;      // of those with a pose
  int gaps = 0;              // runs of images without pose
  // Seconds from the last image with pose before a gap to the first one after it; at the ends of the sequence
  // from its first or to its last image. 0 without gaps.
  double longest_gap = 0;
};

struct OdometryAtImages {
  std::vector<std::optional<Eigen::Isometry3d>> T_odom_camera;  // per image
  OdometryCoverage coverage;
};

// Between two poses: the position on the straight line, the rotation on the shortest way (SLERP), both in
// proportion to the time. before.timestamp <= timestamp <= after.timestamp, the two not equal.
Eigen::Isometry3d InterpolatePose(const TimedPose& before, const TimedPose& after, double timestamp);

// For each stamp the nearest pose within the tolerance, else the one between its two neighbours if they are
// at most max_gap apart, else none; never beyond the first or last pose. Both by growing stamps.
OdometryAtImages PosesAtImages(const std::vector<TimedPose>& odometry, const std::vector<double>& stamps,
                               const OdometryOptions& options = {});

}  // namespace armature
