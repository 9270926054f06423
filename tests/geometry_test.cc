// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/box.h"
#include "geometry/camera.h"
#include "geometry/rotation.h"
#include "geometry/segment.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

TEST(Rotation, LogUndoesExp) {
  for (const Eigen::Vector3d& w :
       {Eigen::Vector3d(0.3, -1.2, 0.7), Eigen::Vector3d(1e-7, 0, 0), Eigen::Vector3d(0, 3.1, 0)}) {
    EXPECT_LT((LogSO3(ExpSO3(w)) - w).norm(), 1e-9);
  }
}

TEST(Rotation, LeftJacobianAgreesWithCentralDifferences) {
  for (const Eigen::Vector3d& w :
       {Eigen::Vector3d(0.3, -1.2, 0.7), Eigen::Vector3d(2e-5, 1e-5, 0), Eigen::Vector3d::Zero().eval()}) {
    const double h = 1e-6;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      const Eigen::Vector3d by_difference = LogSO3(ExpSO3(w + step) * ExpSO3(w - step).transpose()) / (2 * h);
      EXPECT_LT((LeftJacobianSO3(w).col(i) - by_difference).norm(), 1e-7);
    }
  }
}

TEST(Rotation, AnglesWrapToHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(WrapAngle(M_PI), -M_PI);
  EXPECT_NEAR(WrapAngle(-3.5 * M_PI), 0.5 * M_PI, 1e-12);
}

TEST(Viewpoint, AnObjectFacingTheCameraHasItsFrontTowardsIt) {
  const Eigen::Matrix3d R = RotationFromViewpoint({0, 0, 0}, Eigen::Vector3d::UnitZ());
  EXPECT_LT((R * Eigen::Vector3d::UnitZ() - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((R * Eigen::Vector3d::UnitY() - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
}

TEST(Viewpoint, AzimuthAndElevationAreTheDirectionOfTheCamera) {
  const Viewpoint viewpoint{0.6, 0.3, 0.2};
  const Eigen::Vector3d ray(0.2, -0.1, 1);
  const Eigen::Vector3d camera_in_object =
      -RotationFromViewpoint(viewpoint, ray).transpose() * ray.normalized();
  const Eigen::Vector3d expected(std::cos(0.3) * std::sin(0.6), std::sin(0.3), std::cos(0.3) * std::cos(0.6));
  EXPECT_LT((camera_in_object - expected).norm(), 1e-12);
}

TEST(Viewpoint, IsRecoveredFromTheRotation) {
  const Viewpoint viewpoint{-2.1, 0.4, -0.3};
  const Eigen::Vector3d ray(-0.3, 0.2, 1);
  const Viewpoint recovered = ViewpointFromRotation(RotationFromViewpoint(viewpoint, ray), ray);
  EXPECT_NEAR(recovered.azimuth, viewpoint.azimuth, 1e-12);
  EXPECT_NEAR(recovered.elevation, viewpoint.elevation, 1e-12);
  EXPECT_NEAR(recovered.tilt, viewpoint.tilt, 1e-12);
}

TEST(Viewpoint, UprightRotationStandsUprightAndKeepsTheAzimuth) {
  const Eigen::Vector3d up = Eigen::Vector3d(0.1, -0.9, -0.4).normalized(), ray(0.3, 0.2, 1);
  const Eigen::Matrix3d R = UprightRotation(0.8, up, ray);
  EXPECT_NEAR(R.determinant(), 1, 1e-12);
  EXPECT_LT((R.col(1) - up).norm(), 1e-12);
  EXPECT_NEAR(ViewpointFromRotation(R, ray).azimuth, 0.8, 1e-9);
}

TEST(Viewpoint, HalfATurnIsNoDifferenceForATable) {
  EXPECT_NEAR(AzimuthDifference(M_PI + 0.1, 0, 2), 0.1, 1e-12);
  EXPECT_NEAR(std::abs(AzimuthDifference(M_PI, 0, 1)), M_PI, 1e-12);
}

TEST(Rotation, SmallestTurnsOneDirectionIntoTheOther) {
  const Eigen::Vector3d from(1, 2, 3), to(-2, 0.5, 1);
  const Eigen::Matrix3d R = SmallestRotation(from, to);
  EXPECT_TRUE((R * from.normalized()).isApprox(to.normalized(), 1e-14));
  EXPECT_TRUE((R * from.cross(to)).isApprox(from.cross(to), 1e-14)) << "its axis is across both";
}

TEST(Rotation, SmallestBetweenOppositeDirectionsIsAHalfTurn) {
  for (const Eigen::Vector3d& from : {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0, 0, 1)}) {
    const Eigen::Matrix3d R = SmallestRotation(from, -2 * from);
    EXPECT_TRUE((R * from).isApprox(-from, 1e-14));
    EXPECT_NEAR(R.trace(), -1, 1e-14);
    EXPECT_NEAR(R.determinant(), 1, 1e-14);
  }
}

TEST(Camera, UndistortionUndoesTheBrownModel) {
  Camera camera{640, 480, 500, 510, 320, 240, {-0.2, 0.05, 0.001, -0.002, 0.01}};
  const double x = 0.3, y = -0.2, r2 = x * x + y * y;
  const double radial = 1 - 0.2 * r2 + 0.05 * r2 * r2 + 0.01 * r2 * r2 * r2;
  const double xd = x * radial + 2 * 0.001 * x * y - 0.002 * (r2 + 2 * x * x);
  const double yd = y * radial + 0.001 * (r2 + 2 * y * y) + 2 * -0.002 * x * y;
  const Eigen::Vector2d undistorted = UndistortPixel(camera, {500 * xd + 320, 510 * yd + 240});
  EXPECT_LT((undistorted - Eigen::Vector2d(500 * x + 320, 510 * y + 240)).norm(), 1e-4);
}

TEST(Segment, IsClippedToTheBox) {
  const auto inside = Clipped({{-5, 5}, {15, 5}}, {0, 0, 10, 10});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->p1, Eigen::Vector2d(0, 5));
  EXPECT_EQ(inside->p2, Eigen::Vector2d(10, 5));
  EXPECT_FALSE(Clipped({{-5, 20}, {15, 20}}, {0, 0, 10, 10}));
  EXPECT_FALSE(Clipped({{-5, 8}, {3, 16}}, {0, 0, 10, 10}));
}

TEST(Segment, DistanceIsSignedAndAngleAcute) {
  EXPECT_DOUBLE_EQ(SignedDistanceToLine({{0, 0}, {10, 0}}, {3, 2}), 2);
  EXPECT_DOUBLE_EQ(SignedDistanceToLine({{0, 0}, {10, 0}}, {3, -2}), -2);
  EXPECT_NEAR(AcuteAngle({{0, 0}, {1, 0}}, {{0, 0}, {-1, 1}}), M_PI / 4, 1e-12);
}

TEST(Box, OverlapOfHalfShiftedBoxesIsAThird) {
  EXPECT_NEAR(IntersectionOverUnion({0, 0, 2, 1}, {1, 0, 2, 1}), 1.0 / 3, 1e-12);
  EXPECT_EQ(IntersectionOverUnion({0, 0, 1, 1}, {5, 5, 1, 1}), 0);
}

}  // namespace
}  // namespace armature
