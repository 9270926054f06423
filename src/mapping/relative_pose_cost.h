// SPDX-License-Identifier: BSD-3-Clause
// The residual of one edge of a pose graph for Ceres, with its derivatives: the error of
// relative_pose_error.h, whitened: S e with S^T S = Omega (square_root_information.h).
#pragma once

#include <ceres/sized_cost_function.h>

#include "mapping/pose_graph.h"

namespace armature {

// Blocks: the poses `from` and `to` of the edge (pose_block.h). 6 residuals.
class RelativePoseCost : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  // Throws std::invalid_argument when the edge's information is not positive semi-definite.
  explicit RelativePoseCost(const PoseGraphEdge& edge);
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  Eigen::Isometry3d Z_inverse_;
  Matrix6d whitening_;  // S
};

}  // namespace armature
