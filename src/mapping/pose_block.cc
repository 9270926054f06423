// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_block.h"

namespace armature {
namespace {

using LiftJacobian = Eigen::Matrix<double, 7, 6, Eigen::RowMajor>;
using ProjectJacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

}  // namespace

PoseBlock ToPoseBlock(const Eigen::Isometry3d& T) {
  PoseBlock block;
  Eigen::Map<Eigen::Quaterniond>(block.data()) = Eigen::Quaterniond(T.linear()).normalized();
  Eigen::Map<Eigen::Vector3d>(block.data() + 4) = T.translation();
  return block;
}

Eigen::Isometry3d FromPoseBlock(const double* block) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Map<const Eigen::Quaterniond>(block).toRotationMatrix();
  T.translation() = Eigen::Map<const Eigen::Vector3d>(block + 4);
  return T;
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const PoseBlock moved = ToPoseBlock(FromPoseBlock(x) * ExpSE3(Eigen::Map<const Vector6d>(delta)));
  std::copy(moved.begin(), moved.end(), x_plus_delta);
  return true;
}

bool PoseManifold::PlusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<LiftJacobian>(jacobian).setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vector6d>(y_minus_x, 6) = LogSE3(FromPoseBlock(x).inverse() * FromPoseBlock(y));
  return true;
}

bool PoseManifold::MinusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<ProjectJacobian>(jacobian).setIdentity();
  return true;
}

}  // namespace armature
