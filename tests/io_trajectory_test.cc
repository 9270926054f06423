// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/rotation.h"
#include "io/trajectory.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

TEST(Trajectory, ReadsHandWrittenPoses) {
  const testing::TempFolder folder;
  const auto file = folder.Write(
      "t.txt", "# header\n\n1.5 1 2 3 0 0 0.70710678 0.70710678\n\t2.5 4 5 6  0 0 0 -1 # end\r\n");
  const std::vector<TimedPose> poses = ReadTumTrajectory(file);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].timestamp, 1.5);
  EXPECT_EQ(poses[0].line, 3);
  EXPECT_TRUE((poses[0].pose * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1, 3, 3)));
  EXPECT_TRUE(poses[1].pose.linear().isIdentity(1e-12));
}

TEST(Trajectory, WritesWhatItReads) {
  const testing::TempFolder folder;
  std::vector<TimedPose> poses(2);
  poses[0].timestamp = 1305031110.043299;
  poses[1].timestamp = 1305031111.0;
  poses[1].pose.linear() = ExpSO3({0.1, -2.9, 0.4});
  poses[1].pose.translation() = Eigen::Vector3d(-1.25, 1e-7, 300);
  WriteTumTrajectory(folder / "t.txt", poses);
  const std::vector<TimedPose> read = ReadTumTrajectory(folder / "t.txt");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_NEAR(read[0].timestamp, poses[0].timestamp, 1e-6);
  EXPECT_TRUE(read[1].pose.isApprox(poses[1].pose, 1e-8));
}

TEST(Trajectory, WritesQuaternionsWithPositiveRealPart) {
  TimedPose pose;
  pose.pose.linear() = Eigen::AngleAxisd(3.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
  pose.pose.translation() = Eigen::Vector3d(-1e-12, 0, 0);
  EXPECT_EQ(TumLine(pose),
            "0.000000 0.000000000 0.000000000 0.000000000 0.000000000 -0.983985947 0.000000000 0.178246056");
}

TEST(Trajectory, KeepsTheFirstOfRepeatedStampsAndCountsTheRest) {
  const testing::TempFolder folder;
  const auto file =
      folder.Write("t.txt", "1 4 0 0 0 0 0 1\n1 5 0 0 0 0 0 1\n1 6 0 0 0 0 0 1\n2 7 0 0 0 0 0 1\n");
  const TrajectoryFile read = ReadTrajectoryFile(file);
  ASSERT_EQ(read.poses.size(), 2u);
  EXPECT_EQ(read.poses[0].pose.translation().x(), 4);
  EXPECT_EQ(read.poses[1].pose.translation().x(), 7);
  EXPECT_EQ(read.repeated, 2u);
  EXPECT_NE(DescribeRepeatedStamps(file, read).find("t.txt: 2 of 4 poses"), std::string::npos);
  EXPECT_EQ(ReadTrajectory(file, {.repeated = RepeatedStamps::kKept}).size(), 4u);
}

TEST(Trajectory, RejectsStampsOutOfOrder) {
  const testing::TempFolder folder;
  const auto file = folder.Write("t.txt", "1 0 0 0 0 0 0 1\n0.5 0 0 0 0 0 0 1\n");
  for (const auto repeated : {RepeatedStamps::kFirstKept, RepeatedStamps::kKept}) {
    testing::ExpectInputError([&] { ReadTrajectory(file, {.repeated = repeated}); },
                              {"t.txt:2", "line 1", "sort"});
  }
}

TEST(Trajectory, FindsTheNearestStamp) {
  std::vector<TimedPose> poses(3);
  poses[1].timestamp = 1.0;
  poses[2].timestamp = 1.0015;
  EXPECT_EQ(FindStamp(poses, 1.0009), 2u);
  EXPECT_EQ(FindStamp(poses, 1.0005), 1u);
  EXPECT_EQ(FindStamp(poses, 1.0025), 2u);
  EXPECT_EQ(FindStamp(poses, -0.001), 0u);
  EXPECT_FALSE(FindStamp(poses, 0.5));
  EXPECT_FALSE(FindStamp(poses, 1.0035));
  EXPECT_FALSE(FindStamp({}, 0));
}

TEST(TrajectoryOnRealData, ReadsTheSharedTrajectories) {
  ARMATURE_SHARED_DATA_OR_SKIP(folder, "trajectories");
  EXPECT_EQ(ReadTumTrajectory(folder / "freiburg1_xyz-rgbdslam.txt").size(), 788u);
  EXPECT_EQ(ReadTrajectory(folder / "fr2_desk_groundtruth.txt", {.repeated = RepeatedStamps::kKept}).size(),
            20957u);
}

}  // namespace
}  // namespace armature
