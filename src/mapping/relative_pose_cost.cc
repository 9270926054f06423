// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/relative_pose_cost.h"

#include <stdexcept>

#include "mapping/pose_block.h"
#include "mapping/square_root_information.h"

namespace armature {
namespace {

void StoreJacobian(const Matrix6d& jacobian, double* block) {
  Eigen::Map<PoseBlockJacobian> stored(block);
  stored.leftCols<6>() = jacobian;
  stored.col(6).setZero();
}

}  // namespace

RelativePoseCost::RelativePoseCost(const PoseGraphEdge& edge) : T_to_from_(edge.T_from_to.inverse()) {
  const std::optional<Matrix6d> whitening = SquareRootInformation(edge.information);
  if (!whitening)
    throw std::invalid_argument("pose graph: an edge's information is not positive semi-definite");
  whitening_ = *whitening;
}

bool RelativePoseCost::Evaluate(double const* const* parameters, double* residuals,
                                double** jacobians) const {
  const Eigen::Isometry3d T_world_from = FromPoseBlock(parameters[0]);
  const Eigen::Isometry3d T_world_to = FromPoseBlock(parameters[1]);
  const Eigen::Isometry3d T_from_to = T_world_from.inverse() * T_world_to;
  const Vector6d r = LogSE3(T_to_from_ * T_from_to);
  Eigen::Map<Vector6d>(residuals, 6) = whitening_ * r;
  if (jacobians == nullptr) return true;
  const Matrix6d by_to = whitening_ * RightJacobianInverseSE3(r);
  if (jacobians[0] != nullptr) StoreJacobian(-by_to * AdjointSE3(T_from_to.inverse()), jacobians[0]);
  if (jacobians[1] != nullptr) StoreJacobian(by_to, jacobians[1]);
  return true;
}

}  // namespace armature
