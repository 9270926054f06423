// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulated_odometry.h"

#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr double kTranslationNoise = 0.01;         // share of a motion's length
constexpr double kRotationNoise = 0.02 * kDegree;  // radians, each axis

}  // namespace

Eigen::Isometry3d OdometrySimulator::Next(const Eigen::Isometry3d& T_world_camera) {
  if (T_world_last_) {
    Eigen::Isometry3d motion = T_world_last_->inverse() * T_world_camera;
    const double length = motion.translation().norm();
    Eigen::Vector3d shift, turn;
    for (int axis = 0; axis < 3; ++axis) {
      shift[axis] = random_.Normal(0, kTranslationNoise * length);
      turn[axis] = random_.Normal(0, kRotationNoise);
    }
    motion.translation() = scale_ * (motion.translation() + shift);
    motion.linear() = (motion.linear() * ExpSO3(turn)).eval();
    T_odom_last_ = T_odom_last_ * motion;
  }
  T_world_last_ = T_world_camera;
  return T_odom_last_;
}

}  // namespace armature
