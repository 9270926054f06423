// SPDX-License-Identifier: BSD-3-Clause
// The residuals of a ResectionProblem and their derivatives, term by term. Inside this folder only: the
// problem as Ceres sees it and the normal equations of our own solver are two ways of collecting these rows.
#pragma once

#include "geometry/rotation.h"
#include "resection/resection_problem.h"

namespace armature {

// The unknowns unpacked, with what every term needs of them. Derivatives by rotation are by a turn dw of R
// from the left, exp(dw) R; LeftJacobianSO3(w) leads from there to w.
struct ResectionState {
  Eigen::Matrix3d R;
  Eigen::Vector3d T;
  Eigen::Map<const Eigen::VectorXd> lambda;

  // x: 6+B numbers, see ResectionProblem; has to outlive the state.
  ResectionState(const ResectionProblem& problem, const double* x) : lambda(x + 6, problem.Modes()) {
    R = ExpSO3(Eigen::Vector3d(x[0], x[1], x[2])) * problem.R0;
    T = problem.T0 + Eigen::Vector3d(x[3], x[4], x[5]);
  }
};

// A residual of a point P = R X + T of the object.
struct PointRow {
  double residual = 0;
  Eigen::Vector3d gradient{0, 0, 0};  // by P
  Eigen::Vector3d RX{0, 0, 0};

  // d(exp(dw) R X) = -[RX]x dw, and -g^T [a]x = (a x g)^T
  Eigen::Vector3d ByRotation() const { return RX.cross(gradient); }
  Eigen::Vector3d ByObjectPoint(const ResectionState& state) const { return state.R.transpose() * gradient; }
};

PointRow LineRow(const PointOnLineTerm& term, const Camera& camera, const ResectionState& state);
PointRow PlaneRow(const PointOnPlaneTerm& term, const ResectionState& state);

// Three residuals of the normal term, with derivatives by (dw, v, lambda).
struct NormalRows {
  Eigen::Vector3d residuals{0, 0, 0};
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 6 + kMaxModes> by_unknowns;  // 3 x (6+B)
};
NormalRows MakeNormalRows(const ResectionProblem& problem, const ResectionState& state);

// The direction dw in which the prior's yaw (number 3 of its z) grows: its derivative by dw.
Eigen::Vector3d YawByRotation(const TrackPrior& prior, const ResectionState& state);

// The factor a = 1 / sqrt(1 + squared / c^2) that makes a group of residuals robust as a whole.
double GroupWeight(double squared, double loss_scale);

}  // namespace armature
