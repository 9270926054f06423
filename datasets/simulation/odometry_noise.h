// SPDX-License-Identifier: BSD-3-Clause
// How a monocular odometry corrupts the true motion.
#pragma once

namespace armature {

struct OdometryNoise {
  double scale = 0.4;                // odometry's units a metre, at the start
  double scale_drift = 0.05;         // of the last motion's scale against the first's, share; grows evenly
  double heading_drift_deg = 3;      // about the vertical, at the end; grows evenly
  double translation_noise = 0.01;   // sigma each axis, share of each motion's length
  double rotation_noise_deg = 0.02;  // sigma each axis, each motion
  bool tells_up = true;              // whether the direction of gravity is known, as a flying robot knows it
};

}  // namespace armature
