// SPDX-License-Identifier: BSD-3-Clause
// Rigid motions: the exponential map of SE(3) and its derivatives.
//
// A tangent vector is xi = (w, v): rotation (radians) first, then translation (metres). So is everything that
// is built on it: residuals, Jacobians, covariances, information matrices. (g2o's files put the translation
// first; their reader swaps the two.)
//
//   Exp(xi) = [ exp(w)  J_l(w) v ]     with exp and J_l of SO(3), see rotation.h.
//             [   0         1    ]
#pragma once

#include <Eigen/Geometry>

namespace armature {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// exp: se(3) -> SE(3).
Eigen::Isometry3d ExpSE3(const Vector6d& xi);

// The inverse of ExpSE3, |w| <= pi. Its translation is J_l(w)^-1 t, not t.
Vector6d LogSE3(const Eigen::Isometry3d& T);

// Ad_T with T Exp(d) T^-1 = Exp(Ad_T d).
Matrix6d AdjointSE3(const Eigen::Isometry3d& T);

// J_l with Exp(xi + d) = Exp(J_l d) Exp(xi) to first order. J_r(xi) = J_l(-xi) stands on the other side:
// Exp(xi + d) = Exp(xi) Exp(J_r d).
Matrix6d LeftJacobianSE3(const Vector6d& xi);
Matrix6d RightJacobianSE3(const Vector6d& xi);

// Their inverses, |w| < 2 pi:
//   Log(Exp(d) Exp(xi)) = xi + J_l^-1 d,   Log(Exp(xi) Exp(d)) = xi + J_r^-1 d   to first order.
Matrix6d LeftJacobianInverseSE3(const Vector6d& xi);
Matrix6d RightJacobianInverseSE3(const Vector6d& xi);

}  // namespace armature
