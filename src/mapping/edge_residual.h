// SPDX-License-Identifier: BSD-3-Clause
// The residual of one edge of a pose graph, with exact Jacobians.
//
//   r = Log(Z^-1 X_i^-1 X_j),   whitened: S r with S^T S = Omega (square_root_information.h).
//
// A step d = (w, v) moves a pose on the right, X Exp(d). With E = Z^-1 X_i^-1 X_j = Exp(r):
//   d_j:  E Exp(d)                           so   dr/d_j =  J_r^-1(r)
//   d_i:  Z^-1 Exp(-d) X_i^-1 X_j
//         = E Exp(-Ad(X_j^-1 X_i) d)         so   dr/d_i = -J_r^-1(r) Ad(X_j^-1 X_i)
#pragma once

#include "mapping/pose_graph.h"

namespace armature {

struct LinearResidual {
  Vector6d residual;        // S r
  Matrix6d by_from, by_to;  // S dr/d_i, S dr/d_j
};

class EdgeResidual {
 public:
  // Throws std::invalid_argument when the edge's information is not positive semi-definite.
  explicit EdgeResidual(const PoseGraphEdge& edge);

  Vector6d At(const Eigen::Isometry3d& T_world_from, const Eigen::Isometry3d& T_world_to) const;
  LinearResidual LinearisedAt(const Eigen::Isometry3d& T_world_from,
                              const Eigen::Isometry3d& T_world_to) const;

 private:
  Eigen::Isometry3d T_to_from_;  // Z^-1
  Matrix6d whitening_;           // S
};

}  // namespace armature
