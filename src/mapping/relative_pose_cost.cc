// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/relative_pose_cost.h"

#include <stdexcept>

#include "mapping/pose_block.h"
#include "mapping/relative_pose_error.h"
#include "mapping/square_root_information.h"

namespace armature {

RelativePoseCost::RelativePoseCost(const PoseGraphEdge& edge) : Z_inverse_(edge.T_from_to.inverse()) {
  const std::optional<Matrix6d> whitening = SquareRootInformation(edge.information);
  if (!whitening) throw std::invalid_argument("pose graph: information that is not positive semi-definite");
  whitening_ = *whitening;
}

bool RelativePoseCost::Evaluate(double const* const* parameters, double* residuals,
                                double** jacobians) const {
  const RelativePoseError error(Z_inverse_, FromBlock(parameters[0]), FromBlock(parameters[1]));
  Eigen::Map<Vector6d>{residuals}.noalias() = whitening_ * error.e;
  if (!jacobians) return true;
  const Matrix6d by_to = whitening_ * error.ByTo();
  if (jacobians[0]) StoreByStep(by_to * error.ToByFrom(), jacobians[0]);
  if (jacobians[1]) StoreByStep(by_to, jacobians[1]);
  return true;
}

}  // namespace armature
