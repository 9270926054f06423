// SPDX-License-Identifier: BSD-3-Clause
// Stands in for a monocular visual odometry: unknown scale, slow drift.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "datasets/random.h"

namespace armature {

class OdometrySimulator {
 public:
  // `scale`: odometry's units a metre. Each motion is off by 1 % of its length and 0.02 degrees.
  OdometrySimulator(std::uint64_t seed, double scale) : random_(seed), scale_(scale) {}

  // T_odom_camera of the next frame; the first camera is the origin.
  Eigen::Isometry3d Next(const Eigen::Isometry3d& T_world_camera);

 private:
  Random random_;
  double scale_;
  std::optional<Eigen::Isometry3d> T_world_last_;
  Eigen::Isometry3d T_odom_last_ = Eigen::Isometry3d::Identity();
};

}  // namespace armature
