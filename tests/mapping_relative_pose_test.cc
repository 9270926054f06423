// SPDX-License-Identifier: BSD-3-Clause
// Errors between two poses: whitened with full information, and with the odometry's scale.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mapping/map_factors.h"
#include "mapping/pose_block.h"
#include "mapping/relative_pose_cost.h"
#include "mapping/square_root_information.h"
#include "support/synthetic_pose_graph.h"

namespace armature {
namespace {

using testing::RandomInformation;
using testing::RandomTangent;
using ByBlock = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

TEST(SquareRootInformation, IsTheUpperFactorNotTheLower) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Matrix6d omega = RandomInformation(random);
    const auto S = SquareRootInformation(omega);
    ASSERT_TRUE(S);
    EXPECT_TRUE((S->transpose() * *S).isApprox(omega, 1e-12));
    EXPECT_FALSE((*S * S->transpose()).isApprox(omega, 1e-3));
  }
}

TEST(SquareRootInformation, ExistsForASingularMatrix) {
  std::mt19937 random(1);
  Matrix6d omega = RandomInformation(random);
  omega.row(2).setZero();
  omega.col(2).setZero();
  const auto S = SquareRootInformation(omega);
  ASSERT_TRUE(S);
  EXPECT_TRUE((S->transpose() * *S).isApprox(omega, 1e-12));
  EXPECT_TRUE(SquareRootInformation(Matrix6d::Zero())->isZero());
}

TEST(SquareRootInformation, DoesNotExistForIndefiniteOrUnsymmetricMatrices) {
  Matrix6d omega = Matrix6d::Identity();
  omega(4, 4) = -1;
  EXPECT_FALSE(SquareRootInformation(omega));
  omega(4, 4) = 1;
  omega(1, 2) = omega(2, 1) = 1.5;
  EXPECT_FALSE(SquareRootInformation(omega));
  omega(1, 2) = omega(2, 1) = 0;
  omega(0, 5) = 0.5;
  EXPECT_FALSE(SquareRootInformation(omega));
}

struct ExampleEdge {
  PoseGraphEdge edge;
  Eigen::Isometry3d from, to;
};

// Off by about a radian and a metre, with coupled errors.
ExampleEdge MakeExampleEdge() {
  std::mt19937 random(4);
  ExampleEdge example;
  example.from = ExpSE3(RandomTangent(random, 1, 5));
  example.to = ExpSE3(RandomTangent(random, 1, 5));
  example.edge.T_from_to = example.from.inverse() * example.to * ExpSE3(RandomTangent(random, 0.6, 1));
  example.edge.information = RandomInformation(random);
  return example;
}

using EdgeResidual = std::function<Vector6d(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to)>;

// Compares the derivatives by both poses with central differences.
void ExpectDerivatives(const ExampleEdge& e, const EdgeResidual& residual, const ByBlock& by_from,
                       const ByBlock& by_to) {
  EXPECT_EQ(by_from.col(6).norm() + by_to.col(6).norm(), 0);
  const double h = 1e-6;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Isometry3d step = ExpSE3(h * Vector6d::Unit(i)), back = step.inverse();
    const Vector6d from_difference = residual(e.from * step, e.to) - residual(e.from * back, e.to);
    const Vector6d to_difference = residual(e.from, e.to * step) - residual(e.from, e.to * back);
    EXPECT_LT((by_from.col(i) - from_difference / (2 * h)).norm(), 1e-6);
    EXPECT_LT((by_to.col(i) - to_difference / (2 * h)).norm(), 1e-6);
  }
}

Vector6d Evaluate(const RelativePoseCost& cost, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                  double** jacobians = nullptr) {
  const PoseBlock from_block = ToBlock(from), to_block = ToBlock(to);
  const double* blocks[] = {from_block.data(), to_block.data()};
  Vector6d residual;
  EXPECT_TRUE(cost.Evaluate(blocks, residual.data(), jacobians));
  return residual;
}

TEST(RelativePoseCost, SquaredNormIsTheWeightedCost) {
  const ExampleEdge e = MakeExampleEdge();
  const Vector6d r = LogSE3(e.edge.T_from_to.inverse() * e.from.inverse() * e.to);
  EXPECT_NEAR(Evaluate(RelativePoseCost(e.edge), e.from, e.to).squaredNorm(), r.dot(e.edge.information * r),
              1e-9);
}

TEST(RelativePoseCost, JacobiansAgreeWithCentralDifferences) {
  const ExampleEdge e = MakeExampleEdge();
  const RelativePoseCost cost(e.edge);
  ByBlock by_from, by_to;
  double* jacobians[] = {by_from.data(), by_to.data()};
  Evaluate(cost, e.from, e.to, jacobians);
  ExpectDerivatives(
      e, [&](const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) { return Evaluate(cost, from, to); },
      by_from, by_to);
}

TEST(RelativePoseCost, RefusesIndefiniteInformation) {
  PoseGraphEdge edge;
  edge.information(4, 4) = -1;
  EXPECT_THROW(RelativePoseCost{edge}, std::invalid_argument);
}

Vector6d Evaluate(const OdometryCost& cost, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                  const Eigen::Vector2d& log_scale, double** jacobians = nullptr) {
  const PoseBlock from_block = ToBlock(from), to_block = ToBlock(to);
  const double* blocks[] = {from_block.data(), to_block.data(), &log_scale[0], &log_scale[1]};
  Vector6d residual;
  EXPECT_TRUE(cost.Evaluate(blocks, residual.data(), jacobians));
  return residual;
}

TEST(OdometryCost, JacobiansAgreeWithCentralDifferences) {
  const ExampleEdge e = MakeExampleEdge();
  OdometryFactor factor;
  factor.T_from_to = e.edge.T_from_to;
  factor.rotation_sigma = 0.3;
  factor.translation_sigma = 2;
  factor.share = 0.3;
  const OdometryCost cost(factor);
  const Eigen::Vector2d log_scale(0.2, -0.4);
  ByBlock by_from, by_to;
  Vector6d by_scale[2];
  double* jacobians[] = {by_from.data(), by_to.data(), by_scale[0].data(), by_scale[1].data()};
  Evaluate(cost, e.from, e.to, log_scale, jacobians);
  ExpectDerivatives(
      e,
      [&](const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
        return Evaluate(cost, from, to, log_scale);
      },
      by_from, by_to);
  const double h = 1e-6;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(i);
    const Vector6d difference =
        Evaluate(cost, e.from, e.to, log_scale + step) - Evaluate(cost, e.from, e.to, log_scale - step);
    EXPECT_LT((by_scale[i] - difference / (2 * h)).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace armature
