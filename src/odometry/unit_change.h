// SPDX-License-Identifier: BSD-3-Clause
// An odometry that goes on in another unit.
#pragma once

#include <Eigen/Core>

namespace armature {

// A change of unit at an earlier frame, known now: positions from there on move towards `from`.
struct UnitChange {
  double timestamp = 0;                            // seconds: of the last frame before it
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  // the camera's position there
  double factor = 1;                               // by which later steps were too long

  Eigen::Vector3d Undo(const Eigen::Vector3d& position) const { return from + (position - from) / factor; }
};

}  // namespace armature
