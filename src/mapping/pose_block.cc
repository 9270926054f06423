// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_block.h"

#include "geometry/rotation.h"

namespace armature {

PoseBlock ToBlock(const Eigen::Isometry3d& pose) {
  PoseBlock block;
  block << pose.translation(), Eigen::Quaterniond(pose.linear()).normalized().coeffs();
  return block;
}

Eigen::Isometry3d FromBlock(const double* block) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Map<const Eigen::Quaterniond>(block + 3).toRotationMatrix();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(block);
  return pose;
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const Eigen::Map<const Eigen::Quaterniond> q(x + 3);
  const Eigen::Map<const Eigen::Vector3d> w(delta), v(delta + 3);
  Eigen::Map<Eigen::Vector3d> moved{x_plus_delta};
  Eigen::Map<Eigen::Quaterniond> turned{x_plus_delta + 3};
  moved = Eigen::Map<const Eigen::Vector3d>(x) + q * v;
  turned = (q * Eigen::Quaterniond(ExpSO3(w))).normalized();
  return true;
}

bool PoseManifold::PlusJacobian(const double*, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>>(jacobian).setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  const Eigen::Map<const Eigen::Quaterniond> from(x + 3), to(y + 3);
  Eigen::Map<Eigen::Vector3d> w{y_minus_x}, v{y_minus_x + 3};
  w = LogSO3((from.conjugate() * to).toRotationMatrix());
  v = from.conjugate() * (Eigen::Map<const Eigen::Vector3d>(y) - Eigen::Map<const Eigen::Vector3d>(x));
  return true;
}

bool PoseManifold::MinusJacobian(const double*, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>>(jacobian).setIdentity();
  return true;
}

}  // namespace armature
