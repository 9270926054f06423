// SPDX-License-Identifier: BSD-3-Clause
// Which pose of an estimated trajectory is of the same time as which true one.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/timed_pose.h"

namespace armature {

struct PosePair {
  double timestamp = 0;                                        // seconds, the estimate's
  Eigen::Isometry3d estimate = Eigen::Isometry3d::Identity();  // T_world_camera, estimated world and unit
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();     // T_world_camera, metres
};

// Poses of both at most the tolerance apart in time, each in one pair at most: the closest pair first, then
// the closest of what is left, of equally close ones the earliest. By growing stamps of the estimate. Both by
// growing stamps, repeated ones allowed. The time it takes grows as n log n, whatever the tolerance.
std::vector<PosePair> PairPoses(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth,
                                double tolerance_seconds);

}  // namespace armature
