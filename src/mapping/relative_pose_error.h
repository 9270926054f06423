// SPDX-License-Identifier: BSD-3-Clause
// How far two poses are from a measured motion between them, with exact derivatives.
//
//   e = Log(Z^-1 X_i^-1 X_j),   Z the motion from i to j as it was measured.
//
// A step d = (w, v) moves a pose on the right, X Exp(d). With E = Z^-1 X_i^-1 X_j = Exp(e):
//   d_j:  E Exp(d)                                            so   de/d_j =  J_r^-1(e)
//   d_i:  Z^-1 Exp(-d) X_i^-1 X_j = E Exp(-Ad(X_j^-1 X_i) d)  so   de/d_i = -J_r^-1(e) Ad(X_j^-1 X_i)
#pragma once

#include "geometry/se3.h"

namespace armature {

struct RelativePoseError {
  Eigen::Isometry3d T_from_to;  // X_i^-1 X_j
  Vector6d e;

  RelativePoseError(const Eigen::Isometry3d& Z_inverse, const Eigen::Isometry3d& X_i,
                    const Eigen::Isometry3d& X_j)
      : T_from_to(X_i.inverse() * X_j), e(LogSE3(Z_inverse * T_from_to)) {}

  // de/d_j.
  Matrix6d ByTo() const { return RightJacobianInverseSE3(e); }
  // The step of X_j that changes e as a step of X_i does: de/d_i = de/d_j d_j/d_i.
  Matrix6d ToByFrom() const { return -AdjointSE3(T_from_to.inverse()); }
};

}  // namespace armature
