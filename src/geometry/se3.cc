// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/se3.h"

#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

// The factors of Q below lose up to |w|^-4 of their digits; under this angle their Taylor series, cut after
// three terms, are exact to 1e-12.
constexpr double kSeriesAngle = 0.1;  // radians

struct CouplingFactors {
  double a = 0;  // (t - sin t) / t^3
  double b = 0;  // (t^2 + 2 cos t - 2) / (2 t^4)
  double c = 0;  // (2 t - 3 sin t + t cos t) / (2 t^5)
};

CouplingFactors FactorsAt(double t) {
  const double t2 = t * t;
  if (t < kSeriesAngle) {
    return {1 / 6.0 - t2 / 120 * (1 - t2 / 42), 1 / 24.0 - t2 / 720 * (1 - t2 / 56),
            1 / 120.0 - t2 / 2520 * (1 - t2 / 48)};
  }
  const double sine = std::sin(t), cosine = std::cos(t);
  return {(t - sine) / (t2 * t), (t2 + 2 * cosine - 2) / (2 * t2 * t2),
          (2 * t - 3 * sine + t * cosine) / (2 * t2 * t2 * t)};
}

// How the translation turns with w: the block Q of J_l (Barfoot, State Estimation for Robotics, eq. 7.86).
// It is the series sum over m, n of W^m V W^n / (m + n + 2)!, closed with W^3 = -|w|^2 W.
Eigen::Matrix3d CouplingBlock(const Eigen::Vector3d& w, const Eigen::Vector3d& v) {
  const CouplingFactors f = FactorsAt(w.norm());
  const Eigen::Matrix3d W = Skew(w), V = Skew(v);
  const Eigen::Matrix3d WV = W * V, VW = V * W;
  const Eigen::Matrix3d WVW = WV * W;
  return 0.5 * V + f.a * (WV + VW + WVW) + f.b * (W * WV + VW * W - 3 * WVW) + f.c * (WVW * W + W * WVW);
}

}  // namespace

Eigen::Isometry3d ExpSE3(const Vector6d& xi) {
  const Eigen::Vector3d w = xi.head<3>();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = ExpSO3(w);
  T.translation() = LeftJacobianSO3(w) * xi.tail<3>();
  return T;
}

Vector6d LogSE3(const Eigen::Isometry3d& T) {
  const Eigen::Vector3d w = LogSO3(T.linear());
  Vector6d xi;
  xi << w, LeftJacobianInverseSO3(w) * T.translation();
  return xi;
}

Matrix6d AdjointSE3(const Eigen::Isometry3d& T) {
  Matrix6d A;
  A << T.linear(), Eigen::Matrix3d::Zero(), Skew(T.translation()) * T.linear(), T.linear();
  return A;
}

Matrix6d LeftJacobianSE3(const Vector6d& xi) {
  const Eigen::Matrix3d J = LeftJacobianSO3(xi.head<3>());
  Matrix6d jacobian;
  jacobian << J, Eigen::Matrix3d::Zero(), CouplingBlock(xi.head<3>(), xi.tail<3>()), J;
  return jacobian;
}

Matrix6d RightJacobianSE3(const Vector6d& xi) { return LeftJacobianSE3(-xi); }

Matrix6d LeftJacobianInverseSE3(const Vector6d& xi) {
  const Eigen::Matrix3d inverse = LeftJacobianInverseSO3(xi.head<3>());
  const Eigen::Matrix3d Q = CouplingBlock(xi.head<3>(), xi.tail<3>());
  Matrix6d jacobian;
  jacobian << inverse, Eigen::Matrix3d::Zero(), -inverse * Q * inverse, inverse;
  return jacobian;
}

Matrix6d RightJacobianInverseSE3(const Vector6d& xi) { return LeftJacobianInverseSE3(-xi); }

}  // namespace armature
