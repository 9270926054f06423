// SPDX-License-Identifier: BSD-3-Clause
// The residual of one edge of a pose graph, with exact Jacobians.
//
//   r = Log(Z^-1 X_i^-1 X_j),   whitened: S r with S^T S = Omega (square_root_information.h).
//
// Steps are on the right (pose_block.h), X Exp(d). With E = Z^-1 X_i^-1 X_j = Exp(r):
//   d_j:  E Exp(d)                           so   dr/d_j =  J_r^-1(r)
//   d_i:  Z^-1 Exp(-d) X_i^-1 X_j
//         = E Exp(-Ad(X_j^-1 X_i) d)         so   dr/d_i = -J_r^-1(r) Ad(X_j^-1 X_i)
#pragma once

#include <ceres/sized_cost_function.h>

#include "mapping/pose_graph.h"

namespace armature {

class RelativePoseCost : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  // Blocks: the poses `from` and `to` of the edge. Throws std::invalid_argument when the information is not
  // positive semi-definite.
  explicit RelativePoseCost(const PoseGraphEdge& edge);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  Eigen::Isometry3d T_to_from_;  // Z^-1
  Matrix6d whitening_;           // S
};

}  // namespace armature
