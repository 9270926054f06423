// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/edge_residual.h"

#include <stdexcept>

#include "mapping/square_root_information.h"

namespace armature {

EdgeResidual::EdgeResidual(const PoseGraphEdge& edge) : T_to_from_(edge.T_from_to.inverse()) {
  const std::optional<Matrix6d> whitening = SquareRootInformation(edge.information);
  if (!whitening) throw std::invalid_argument("pose graph: information that is not positive semi-definite");
  whitening_ = *whitening;
}

Vector6d EdgeResidual::At(const Eigen::Isometry3d& T_world_from, const Eigen::Isometry3d& T_world_to) const {
  return whitening_ * LogSE3(T_to_from_ * (T_world_from.inverse() * T_world_to));
}

LinearResidual EdgeResidual::LinearisedAt(const Eigen::Isometry3d& T_world_from,
                                          const Eigen::Isometry3d& T_world_to) const {
  const Eigen::Isometry3d T_from_to = T_world_from.inverse() * T_world_to;
  const Vector6d r = LogSE3(T_to_from_ * T_from_to);
  LinearResidual linear;
  linear.residual = whitening_ * r;
  linear.by_to = whitening_ * RightJacobianInverseSE3(r);
  linear.by_from = -linear.by_to * AdjointSE3(T_from_to.inverse());
  return linear;
}

}  // namespace armature
