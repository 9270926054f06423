// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "io/trajectory.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;

// A quarter of a turn about z, at (1, 2, 3).
Eigen::Isometry3d QuarterTurn() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() << 1, 2, 3;
  return pose;
}

const char* const kTum = "5.5 1 2 3 0 0 0.70710678 0.70710678\n";
const char* const kKitti = "0 -1 0 1 1.0e+00 0 0 2 0 0 1 3\n";
const char* const kEuroc =
    "#timestamp [ns],p_x [m],p_y [m],p_z [m],q_w [],q_x [],q_y [],q_z [],v_x,v_y\n"
    "5500000000, 1, 2, 3, 0.70710678, 0, 0, 0.70710678, 9, 9\n";

class TrajectoryFormats : public ::testing::Test {
 protected:
  std::vector<TimedPose> Read(const std::string& content, const TrajectoryReading& reading = {}) const {
    return ReadTrajectory(folder_.Write("t.txt", content), reading);
  }
  void ExpectError(const std::string& content, const std::vector<std::string>& texts,
                   const TrajectoryReading& reading = {}) const {
    ExpectInputError([&] { Read(content, reading); }, texts);
  }
  testing::TempFolder folder_;
};

TEST_F(TrajectoryFormats, AreToldByTheFirstLine) {
  for (const char* const content : {kTum, kKitti, kEuroc}) {
    const auto poses = Read(content);
    ASSERT_EQ(poses.size(), 1u) << content;
    EXPECT_TRUE(poses[0].pose.isApprox(QuarterTurn(), 1e-8)) << content;
  }
  EXPECT_EQ(Read(kTum)[0].timestamp, 5.5);
  EXPECT_EQ(Read(kEuroc)[0].timestamp, 5.5);
  EXPECT_EQ(Read(kEuroc)[0].line, 2);
}

TEST_F(TrajectoryFormats, CanBeForced) {
  EXPECT_EQ(Read(kTum, {.format = TrajectoryFormat::kTum}).size(), 1u);
  ExpectError(kTum, {"t.txt:1", "8 numbers", "KITTI", "12"}, {.format = TrajectoryFormat::kKitti});
  ExpectError(kKitti, {"t.txt:1", "12 numbers", "TUM", "qx qy qz qw"}, {.format = TrajectoryFormat::kTum});
  ExpectError(kTum, {"t.txt:1", "EuRoC", "timestamp,px"}, {.format = TrajectoryFormat::kEuroc});
  EXPECT_EQ(TrajectoryFormatFromName("euroc"), TrajectoryFormat::kEuroc);
  EXPECT_EQ(TrajectoryFormatFromName("auto"), TrajectoryFormat::kAuto);
  ExpectInputError([] { TrajectoryFormatFromName("kiti"); }, {"'kiti'", "'kitti'"});
}

TEST_F(TrajectoryFormats, KittiTakesStampsOrNumbersItsLines) {
  const std::string two = std::string(kKitti) + kKitti;
  EXPECT_EQ(Read(two)[1].timestamp, 1);
  EXPECT_EQ(Read(two, {.rate = 10})[1].timestamp, 0.1);
  EXPECT_EQ(Read(two, {.stamps = {3, 7}})[1].timestamp, 7);
  ExpectError(two, {"t.txt", "2 poses", "3 stamps"}, {.stamps = {3, 7, 8}});
}

TEST_F(TrajectoryFormats, RotationsBecomeOrthonormal) {
  const Eigen::Matrix3d R = Read("0 -1.0001 0 1 1 0 0 2 0 0 1 3\n")[0].pose.linear();
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST_F(TrajectoryFormats, DoNotMix) {
  ExpectError(std::string(kTum) + kKitti, {"t.txt:2", "12 numbers", "TUM", "8"});
  ExpectError(std::string(kKitti) + kTum, {"t.txt:2", "8 numbers", "KITTI", "12"});
  ExpectError(std::string(kEuroc) + kTum, {"t.txt:3", "EuRoC", "timestamp,px"});
  ExpectError(std::string(kTum) + "6,1,2,3,0,0,0,1\n", {"t.txt:2", "commas", "TUM"});
}

TEST_F(TrajectoryFormats, ReportLinesThatAreNoPose) {
  ExpectError("1 2 3\n", {"t.txt:1", "3 numbers", "TUM", "KITTI", "EuRoC"});
  ExpectError("1,2,3\n", {"t.txt:1", "3 numbers between commas"});
  ExpectError("", {"t.txt", "has no pose"});
  ExpectError("# 1 0 0 0 0 0 0 1\n", {"t.txt", "has no pose"});
  ExpectError("5 1 2 3 0 0 0 nan\n", {"t.txt:1", "'nan'", "finite"});
  ExpectError("5,,2,3,1,0,0,0\n", {"t.txt:1", "''", "finite"});
  ExpectInputError([&] { ReadTrajectory(folder_ / "nowhere.txt"); }, {"nowhere.txt", "cannot be opened"});
}

TEST_F(TrajectoryFormats, AHeaderWithoutItsMarkIsCalledOne) {
  ExpectError(std::string("timestamp tx ty tz qx qy qz qw\n") + kTum, {"t.txt:1", "header line", "'#'"});
  ExpectError(std::string("timestamp,px,py,pz,qw,qx,qy,qz\n") + kEuroc, {"t.txt:1", "header line"});
  ExpectError(std::string(kTum) + "timestamp tx ty tz qx qy qz qw\n", {"t.txt:2", "'timestamp'"});
}

TEST_F(TrajectoryFormats, NumbersMayBeWrittenAsOthersDo) {
  const auto poses = Read("\f\n+5.5 1D0 2.0d+0 3 1e-400 0 +0.70710678\v0.70710678\r\n\v\n");
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_TRUE(poses[0].pose.isApprox(QuarterTurn(), 1e-8));
  ExpectError("5 1e400 2 3 0 0 0 1\n", {"t.txt:1", "too large"});
  ExpectError(std::string(1'000'000, ','), {"t.txt:1", "1000000 commas"});
}

TEST_F(TrajectoryFormats, ReportWhatIsNoRotation) {
  ExpectError("5 1 2 3 0 0 0 0.9\n", {"t.txt:1", "length 0.9", "qx qy qz qw"});
  ExpectError("5 1 2 3 0 0 0 0\n", {"t.txt:1", "length 0"});
  ExpectError("5,1,2,3,0.9,0,0,0\n", {"t.txt:1", "length 0.9", "qw,qx,qy,qz"});
  ExpectError("2 0 0 0 0 1 0 0 0 0 1 0\n", {"t.txt:1", "no rotation", "orthonormal"});
  ExpectError("1 0 0 0 0 1 0 0 0 0 -1 0\n", {"t.txt:1", "right-handed"});  // a reflection
}

TEST_F(TrajectoryFormats, ReportStampsOutOfOrder) {
  ExpectError(std::string(kEuroc) + "5400000000,1,2,3,1,0,0,0\n", {"t.txt:3", "line 2"});
  ExpectError("5.5,1,2,3,1,0,0,0\n", {"t.txt:1", "5.5", "nanoseconds"});
}

TEST_F(TrajectoryFormats, ReadsListsOfStamps) {
  EXPECT_EQ(ReadStamps(folder_.Write("times.txt", "0.0\n1.5e-1\n")), (std::vector<double>{0, 0.15}));
  EXPECT_EQ(ReadStamps(folder_.Write("rgb.txt", "# t file\n1 a.png\n2\tb.png\n")),
            (std::vector<double>{1, 2}));
  ExpectInputError([&] { ReadStamps(folder_.Write("times.txt", "1\n1\n")); },
                   {"times.txt:2", "does not follow"});
  ExpectInputError([&] { ReadStamps(folder_.Write("times.txt", "#\n")); }, {"times.txt", "no stamp"});
  ExpectInputError([&] { ReadStamps(folder_.Write("times.txt", "x\n")); }, {"times.txt:1", "'x'"});
}

}  // namespace
}  // namespace armature
