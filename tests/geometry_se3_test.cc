// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "geometry/rotation.h"
#include "geometry/se3.h"

namespace armature {
namespace {

Vector6d Tangent(const Eigen::Vector3d& w, const Eigen::Vector3d& v) {
  Vector6d xi;
  xi << w, v;
  return xi;
}

// Ordinary motions, and those where the closed forms divide by almost 0: at angle 0, on both sides of the
// angle where the series take over, and near pi.
std::vector<Vector6d> Tangents() {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 0.5).normalized(), v(0.7, -3, 1.9);
  std::vector<Vector6d> tangents = {Tangent({0.3, -1.2, 0.7}, {5, -0.2, 1}), Tangent({0, 3.1, 0}, v)};
  for (const double angle : {0.0, 1e-12, 1e-7, 9.9e-5, 1.01e-4, 0.0999, 0.1001, 2.0, 3.1415, 3.14159265}) {
    tangents.push_back(Tangent(angle * axis, v));
  }
  return tangents;
}

// The definition: Exp(xi) is the matrix exponential of [W v; 0 0].
Eigen::Matrix4d MatrixExponential(const Vector6d& xi) {
  Eigen::Matrix4d generator = Eigen::Matrix4d::Zero();
  generator.topLeftCorner<3, 3>() = Skew(xi.head<3>());
  generator.topRightCorner<3, 1>() = xi.tail<3>();
  return generator.exp();
}

// Column i is (f(+h e_i) - f(-h e_i)) / 2h.
template <typename Function>
Matrix6d CentralDifferences(const Function& f) {
  const double h = 1e-6;
  Matrix6d jacobian;
  for (int i = 0; i < 6; ++i) {
    const Vector6d step = h * Vector6d::Unit(i);
    jacobian.col(i) = (f(step) - f(-step)) / (2 * h);
  }
  return jacobian;
}

TEST(SE3, ExpIsTheMatrixExponential) {
  for (const Vector6d& xi : Tangents()) {
    EXPECT_LT((ExpSE3(xi).matrix() - MatrixExponential(xi)).norm(), 1e-11) << xi.transpose();
  }
}

TEST(SE3, LogUndoesExp) {
  for (const Vector6d& xi : Tangents()) {
    EXPECT_LT((LogSE3(ExpSE3(xi)) - xi).norm(), 1e-9) << xi.transpose();
  }
}

// Half a turn has two logarithms; either gives the motion back.
TEST(SE3, ExpUndoesLogAtHalfATurn) {
  const Eigen::Isometry3d T = ExpSE3(Tangent(M_PI * Eigen::Vector3d(2, 1, -2) / 3, {1, 2, 3}));
  EXPECT_TRUE(ExpSE3(LogSE3(T)).isApprox(T, 1e-12));
}

TEST(SE3, LogOfAPureTranslationIsTheTranslation) {
  const Eigen::Isometry3d T(Eigen::Translation3d(1, -2, 3));
  EXPECT_EQ(LogSE3(T), Tangent({0, 0, 0}, {1, -2, 3}));
}

// A quarter turn about z along a circle of radius 1 around (0, 1): the arc is pi/2 long.
TEST(SE3, TranslationOfTheLogIsTheArcNotTheChord) {
  Eigen::Isometry3d T(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  T.translation() = Eigen::Vector3d(1, 1, 0);
  EXPECT_LT((LogSE3(T) - Tangent({0, 0, M_PI / 2}, {M_PI / 2, 0, 0})).norm(), 1e-12);
}

TEST(SE3, AdjointMovesAStepFromOneSideToTheOther) {
  const Eigen::Isometry3d T = ExpSE3(Tangent({0.4, -2, 0.3}, {4, -1, 2}));
  const Vector6d d = Tangent({0.2, 0.1, -0.5}, {-1, 0.3, 2});
  EXPECT_TRUE((T * ExpSE3(d) * T.inverse()).isApprox(ExpSE3(AdjointSE3(T) * d), 1e-12));
}

TEST(SE3, JacobiansAgreeWithCentralDifferences) {
  for (const Vector6d& xi : Tangents()) {
    const Eigen::Isometry3d inverse = ExpSE3(xi).inverse();
    const Matrix6d left =
        CentralDifferences([&](const Vector6d& d) { return LogSE3(ExpSE3(xi + d) * inverse); });
    const Matrix6d right =
        CentralDifferences([&](const Vector6d& d) { return LogSE3(inverse * ExpSE3(xi + d)); });
    EXPECT_LT((LeftJacobianSE3(xi) - left).norm(), 1e-6) << xi.transpose();
    EXPECT_LT((RightJacobianSE3(xi) - right).norm(), 1e-6) << xi.transpose();
  }
}

TEST(SE3, InverseJacobiansAgreeWithCentralDifferences) {
  for (const Vector6d& xi : Tangents()) {
    if (xi.head<3>().norm() > 3.1416 - 1e-3) continue;  // a step would cross pi, where the logarithm jumps
    const Eigen::Isometry3d T = ExpSE3(xi);
    const Matrix6d left = CentralDifferences([&](const Vector6d& d) { return LogSE3(ExpSE3(d) * T); });
    const Matrix6d right = CentralDifferences([&](const Vector6d& d) { return LogSE3(T * ExpSE3(d)); });
    EXPECT_LT((LeftJacobianInverseSE3(xi) - left).norm(), 1e-6) << xi.transpose();
    EXPECT_LT((RightJacobianInverseSE3(xi) - right).norm(), 1e-6) << xi.transpose();
  }
}

TEST(SE3, InverseJacobiansAreTheInverses) {
  for (const Vector6d& xi : Tangents()) {
    EXPECT_TRUE((LeftJacobianInverseSE3(xi) * LeftJacobianSE3(xi)).isIdentity(1e-10)) << xi.transpose();
    EXPECT_TRUE((RightJacobianInverseSE3(xi) * RightJacobianSE3(xi)).isIdentity(1e-10)) << xi.transpose();
  }
}

}  // namespace
}  // namespace armature
