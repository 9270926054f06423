// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/rotation.h"
#include "mapping/pose_block.h"
#include "support/synthetic_pose_graph.h"

namespace armature {
namespace {

using testing::RandomTangent;

const PoseManifold kManifold;

Eigen::Isometry3d Plus(const Eigen::Isometry3d& pose, const Vector6d& step) {
  const PoseBlock x = ToBlock(pose);
  PoseBlock moved;
  EXPECT_TRUE(kManifold.Plus(x.data(), step.data(), moved.data()));
  EXPECT_NEAR(moved.tail<4>().norm(), 1, 1e-15);
  return FromBlock(moved.data());
}

TEST(PoseBlock, IsTranslationThenQuaternion) {
  const Eigen::Isometry3d quarter =
      Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  const PoseBlock block = ToBlock(quarter);
  PoseBlock expected;
  expected << 1, 2, 3, 0, 0, M_SQRT1_2, M_SQRT1_2;
  EXPECT_LT((block - expected).norm(), 1e-15);
  EXPECT_TRUE(FromBlock(block.data()).isApprox(quarter, 1e-15));
}

TEST(PoseManifold, PlusTurnsAndMovesInThePosesFrame) {
  std::mt19937 random(3);
  const Eigen::Isometry3d pose = ExpSE3(RandomTangent(random, 1, 5));
  const Vector6d step = RandomTangent(random, 0.5, 2);
  Eigen::Isometry3d expected = pose * Eigen::Translation3d(step.tail<3>());
  expected.linear() *= ExpSO3(step.head<3>());
  EXPECT_TRUE(Plus(pose, step).isApprox(expected, 1e-14));
}

// What the costs' derivatives stand on: to first order it is the step of X Exp(d).
TEST(PoseManifold, PlusIsTheExponentialToFirstOrder) {
  std::mt19937 random(4);
  const Eigen::Isometry3d pose = ExpSE3(RandomTangent(random, 1, 5));
  const Vector6d direction = RandomTangent(random, 1, 1);
  for (const double h : {1e-3, 1e-4}) {
    const Vector6d step = h * direction;
    EXPECT_LT((LogSE3(pose.inverse() * Plus(pose, step)) - step).norm(), 10 * h * h);
  }
}

TEST(PoseManifold, MinusUndoesPlus) {
  std::mt19937 random(5);
  for (const double size : {0.0, 1e-9, 1e-3, 0.8}) {
    const PoseBlock x = ToBlock(ExpSE3(RandomTangent(random, 1, 5)));
    const Vector6d step = size * RandomTangent(random, 1, 2);
    PoseBlock moved;
    Vector6d back;
    ASSERT_TRUE(kManifold.Plus(x.data(), step.data(), moved.data()));
    ASSERT_TRUE(kManifold.Minus(moved.data(), x.data(), back.data()));
    EXPECT_LT((back - step).norm(), 1e-13 * (1 + step.norm())) << size;
  }
}

TEST(StoreByStep, LeavesTheSeventhColumnZero) {
  const Eigen::Matrix<double, 3, 6> by_step = Eigen::Matrix<double, 3, 6>::Random();
  Eigen::Matrix<double, 3, 7, Eigen::RowMajor> by_block;
  by_block.setConstant(9);
  StoreByStep(by_step, by_block.data());
  EXPECT_EQ(by_block.leftCols<6>(), by_step);
  EXPECT_TRUE(by_block.col(6).isZero(0));
}

}  // namespace
}  // namespace armature
