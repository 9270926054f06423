// SPDX-License-Identifier: BSD-3-Clause
// A trajectory is a list of poses by growing stamps.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace armature {

constexpr double kStampTolerance = 1e-3;  // seconds: two stamps closer than this are the same
// Seconds added to every tolerance on stamps: what doubles keep of one that counts from 1970, and more.
constexpr double kStampRounding = 1e-6;

struct TimedPose {
  double timestamp = 0;  // seconds
  Eigen::Isometry3d pose =
      Eigen::Isometry3d::Identity();  // T_world_camera or T_odom_camera, as its source says
  int line = 0;                       // of the file it was read from
};

// The pose whose stamp is nearest, if it is within the tolerance. Poses by growing stamps.
std::optional<size_t> FindStamp(const std::vector<TimedPose>& poses, double timestamp,
                                double tolerance = kStampTolerance);

}  // namespace armature
