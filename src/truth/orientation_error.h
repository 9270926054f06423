// SPDX-License-Identifier: BSD-3-Clause
// How an estimated object is turned and tilted against the true one.
#pragma once

#include <Eigen/Core>

namespace armature {

// With R_true turned to the nearest symmetric position, R_true^T R_estimated = Ry(azimuth) exp([pitch 0
// roll]): first the object tilts about an axis across its own, then it turns about the true up. True up is
// the true object's y axis, so that no direction of gravity has to be known.
struct OrientationError {
  double azimuth_deg = 0;  // degrees, at most 180 / symmetry order in absolute value
  double pitch_deg = 0;    // degrees about the object's own x axis: leaning forwards (+) or backwards
  double roll_deg = 0;     // degrees about its own z axis: leaning to a side
  double tilt_deg = 0;     // degrees, between the y axes; tilt^2 = pitch^2 + roll^2
  int symmetry_step = 0;   // of the nearest symmetric position, see NearestSymmetryStep
};

// Both rotations into the same frame, T_world_object or T_camera_object. `symmetry_order`: see CategorySpec.
OrientationError CompareOrientation(const Eigen::Matrix3d& R_estimated, const Eigen::Matrix3d& R_true,
                                    int symmetry_order);

}  // namespace armature
