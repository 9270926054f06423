// SPDX-License-Identifier: BSD-3-Clause
#include "odometry/odometry.h"

#include <gtest/gtest.h>

#include "geometry/rotation.h"

namespace armature {
namespace {

TimedPose At(double timestamp, const Eigen::Vector3d& position, const Eigen::Vector3d& rotation = {0, 0, 0}) {
  TimedPose pose{.timestamp = timestamp};
  pose.pose.translation() = position;
  pose.pose.linear() = ExpSO3(rotation);
  return pose;
}

// One pose each 0.1 s, x = 10 t, leaving out those between the two times.
std::vector<TimedPose> Track(int count, double hole_begin = 1e9, double hole_end = 1e9) {
  std::vector<TimedPose> poses;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i;
    if (t < hole_begin || t > hole_end) poses.push_back(At(t, {10 * t, 0, 0}));
  }
  return poses;
}

TEST(InterpolatePose, GoesStraightAndTurnsEvenly) {
  const TimedPose before = At(10, {1, 2, 3}, {0, 0, 0.2}), after = At(12, {3, 2, -1}, {0, 0, 1.0});
  const Eigen::Isometry3d pose = InterpolatePose(before, after, 10.5);
  EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(1.5, 2, 2)));
  EXPECT_TRUE(pose.linear().isApprox(ExpSO3({0, 0, 0.4}), 1e-12));
  EXPECT_TRUE(InterpolatePose(before, after, 10).isApprox(before.pose, 1e-12));
  EXPECT_TRUE(InterpolatePose(before, after, 12).isApprox(after.pose, 1e-12));
}

// 170 to -170 degrees: over 180, not back through 0.
TEST(InterpolatePose, TurnsTheShortWay) {
  const TimedPose before = At(0, {0, 0, 0}, {0, 170 * kDegree, 0}),
                  after = At(1, {0, 0, 0}, {0, -170 * kDegree, 0});
  EXPECT_TRUE(InterpolatePose(before, after, 0.25).linear().isApprox(ExpSO3({0, 175 * kDegree, 0}), 1e-12));
  EXPECT_TRUE(InterpolatePose(before, after, 0.5).linear().isApprox(ExpSO3({0, M_PI, 0}), 1e-9));
}

TEST(PosesAtImages, PrefersAPoseOfTheImageItself) {
  const auto result =
      PosesAtImages({At(0, {1, 0, 0}), At(0.1005, {2, 0, 0}), At(0.2, {9, 0, 0})}, {0, 0.1, 0.2});
  EXPECT_EQ(result.T_odom_camera[1]->translation().x(), 2);
  EXPECT_EQ(result.coverage.images_with_pose, 3);
  EXPECT_EQ(result.coverage.interpolated, 0);
  EXPECT_EQ(result.coverage.gaps, 0);
  EXPECT_EQ(result.coverage.longest_gap, 0);
}

TEST(PosesAtImages, InterpolatesBetweenNeighbours) {
  const auto result = PosesAtImages(Track(5), {0.03, 0.16, 0.4});
  EXPECT_NEAR(result.T_odom_camera[0]->translation().x(), 0.3, 1e-12);
  EXPECT_NEAR(result.T_odom_camera[1]->translation().x(), 1.6, 1e-12);
  EXPECT_EQ(result.coverage.poses, 5);
  EXPECT_EQ(result.coverage.images, 3);
  EXPECT_EQ(result.coverage.images_with_pose, 3);
  EXPECT_EQ(result.coverage.interpolated, 2);
}

TEST(PosesAtImages, NeverGoesBeyondTheEnds) {
  const auto result = PosesAtImages(Track(5), {-0.01, 0.2, 0.41});
  EXPECT_FALSE(result.T_odom_camera[0]);
  EXPECT_TRUE(result.T_odom_camera[1]);
  EXPECT_FALSE(result.T_odom_camera[2]);
  EXPECT_EQ(result.coverage.gaps, 2);
  EXPECT_NEAR(result.coverage.longest_gap, 0.21, 1e-12);
}

// Poses at 0, 0.1, 0.4, 0.5: the 0.3 s between 0.1 and 0.4 are too long to interpolate.
TEST(PosesAtImages, LeavesLongGapsOpen) {
  const std::vector<double> stamps = {0.05, 0.15, 0.25, 0.35, 0.45};
  const auto odometry = Track(6, 0.15, 0.35);
  const auto result = PosesAtImages(odometry, stamps);
  EXPECT_TRUE(result.T_odom_camera[0] && result.T_odom_camera[4]);
  for (const size_t i : {1u, 2u, 3u}) EXPECT_FALSE(result.T_odom_camera[i]);
  EXPECT_EQ(result.coverage.images_with_pose, 2);
  EXPECT_EQ(result.coverage.gaps, 1);
  EXPECT_NEAR(result.coverage.longest_gap, 0.4, 1e-12);
  EXPECT_EQ(PosesAtImages(odometry, stamps, {.max_gap = 0.3}).coverage.interpolated, 5);
}

TEST(PosesAtImages, HasNothingToGiveWithoutOdometry) {
  const auto result = PosesAtImages({}, {0, 1, 3});
  EXPECT_EQ(result.T_odom_camera.size(), 3u);
  EXPECT_EQ(result.coverage.images_with_pose, 0);
  EXPECT_EQ(result.coverage.gaps, 1);
  EXPECT_EQ(result.coverage.longest_gap, 3);
  EXPECT_TRUE(PosesAtImages(Track(3), {}).T_odom_camera.empty());
}

TEST(PosesAtImages, OnePoseIsOfItsImageAlone) {
  const auto result = PosesAtImages({At(1, {1, 2, 3})}, {0.9, 1, 1.1});
  EXPECT_EQ(result.coverage.images_with_pose, 1);
  EXPECT_TRUE(result.T_odom_camera[1]);
}

}  // namespace
}  // namespace armature
