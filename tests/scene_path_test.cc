// SPDX-License-Identifier: BSD-3-Clause
// Paths of the camera.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/scene/camera_path.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

double HeadingDeg(const Isometry3d& T_world_camera) {
  const Vector3d axis = T_world_camera.linear().col(2);
  return std::atan2(axis.y(), axis.x()) / kDegree;
}

double AngleBetweenDeg(double a, double b) { return std::abs(WrapAngle((a - b) * kDegree)) / kDegree; }

CameraPath StillLoop() {
  CameraPath path;
  path.length = 4, path.width = 1.5, path.height = 1.3, path.pitch_deg = 15;
  path.heading_offset_deg = -60, path.overlap = 0.1;
  path.sway = 0, path.sway_deg = 0;
  return path;
}

// The 200th of 220 steps over 1.1 rounds ends the first round.
TEST(CameraPath, LoopClosesAndGoesOn) {
  for (const bool clockwise : {false, true}) {
    CameraPath path = StillLoop();
    path.clockwise = clockwise;
    const std::vector<Isometry3d> poses = CameraPoses(path, 221, 1);
    for (size_t i = 0; i <= 20; ++i) EXPECT_TRUE(poses[i].isApprox(poses[200 + i], 1e-9)) << i;
    EXPECT_GT((poses[100].translation() - poses[0].translation()).norm(), 1.4);
  }
}

TEST(CameraPath, LoopHasConstantSpeedAndItsSize) {
  const std::vector<Isometry3d> poses = CameraPoses(StillLoop(), 441, 1);
  Eigen::AlignedBox3d box;
  const double step = (2 * 2.5 + std::numbers::pi * 1.5) / 400;
  for (size_t i = 0; i < poses.size(); ++i) {
    box.extend(poses[i].translation());
    if (i == 0) continue;
    EXPECT_NEAR((poses[i].translation() - poses[i - 1].translation()).norm(), step, 2e-4 * step + 1e-6);
    EXPECT_LT(AngleBetweenDeg(HeadingDeg(poses[i]), HeadingDeg(poses[i - 1])), 3);
  }
  EXPECT_NEAR(box.sizes().x(), 4, 1e-3);
  EXPECT_NEAR(box.sizes().y(), 1.5, 1e-3);
  EXPECT_EQ(box.sizes().z(), 0);
  EXPECT_TRUE(box.center().isApprox(Vector3d(0, 0, 1.3), 1e-3));
}

// Flying along +x the camera of a loop looks 60 degrees to the right and 15 down.
TEST(CameraPath, LooksBesideTheDirectionOfFlight) {
  const Isometry3d pose = CameraPoses(StillLoop(), 221, 1)[10];
  EXPECT_NEAR(HeadingDeg(pose), -60, 1e-9);
  EXPECT_NEAR(std::asin(-pose.linear().col(2).z()) / kDegree, 15, 1e-9);
  EXPECT_NEAR(pose.linear().col(0).z(), 0, 1e-12);  // level
  EXPECT_LT(pose.linear().col(1).z(), 0);           // y down
  EXPECT_NEAR(pose.linear().determinant(), 1, 1e-12);
}

TEST(CameraPath, TurnsInPlace) {
  CameraPath path;
  path.kind = CameraPath::Kind::kTurn;
  path.centre = {0.5, -0.25}, path.height = 1.4, path.start_deg = 20, path.overlap = 0.1;
  const std::vector<Isometry3d> poses = CameraPoses(path, 111, 1);
  for (const Isometry3d& pose : poses) {
    EXPECT_EQ(pose.translation(), Vector3d(0.5, -0.25, 1.4));  // in spite of the sway
  }
  path.sway_deg = 0;
  const std::vector<Isometry3d> still = CameraPoses(path, 111, 1);
  EXPECT_NEAR(HeadingDeg(still[0]), 20, 1e-9);
  EXPECT_NEAR(HeadingDeg(still[25]), 110, 1e-9);
  EXPECT_TRUE(still[100].isApprox(still[0], 1e-9));
  path.clockwise = true;
  EXPECT_NEAR(HeadingDeg(CameraPoses(path, 111, 1)[25]), -70, 1e-9);
}

TEST(CameraPath, PassesItsKeyframes) {
  CameraPath path;
  path.kind = CameraPath::Kind::kKeyframes;
  path.sway = 0, path.sway_deg = 0;
  path.keyframes = {{{0, 0}, 170}, {{1, 0.5}, -170}, {{2, 0}, -150}};
  const std::vector<Isometry3d> poses = CameraPoses(path, 21, 1);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_LT((poses[10 * i].translation().head<2>() - path.keyframes[i].position).norm(), 1e-12);
    EXPECT_LT(AngleBetweenDeg(HeadingDeg(poses[10 * i]), path.keyframes[i].heading_deg), 1e-9);
  }
  for (size_t i = 1; i < poses.size(); ++i) {  // the shorter way round, without jumps
    EXPECT_LT(AngleBetweenDeg(HeadingDeg(poses[i]), HeadingDeg(poses[i - 1])), 4);
    EXPECT_LT((poses[i].translation() - poses[i - 1].translation()).norm(), 0.2);
  }
}

TEST(CameraPath, PassesKeyframesOfOtherHeightPitchAndRoll) {
  CameraPath path;
  path.kind = CameraPath::Kind::kKeyframes;
  path.sway = 0, path.sway_deg = 0;
  path.height = 1.2, path.pitch_deg = 10;
  path.keyframes = {{{0, 0}, 0, 1.0, 20, 5}, {{1, 0}, 0, 1.6, {}, -10}, {{2, 0}, 0}};
  const std::vector<Isometry3d> poses = CameraPoses(path, 21, 1);
  const auto pitch_deg = [](const Isometry3d& pose) { return std::asin(-pose.linear()(2, 2)) / kDegree; };
  EXPECT_NEAR(poses[0].translation().z(), 1.0, 1e-12);
  EXPECT_NEAR(poses[10].translation().z(), 1.6, 1e-12);
  EXPECT_NEAR(poses[20].translation().z(), 1.2, 1e-12);
  EXPECT_NEAR(pitch_deg(poses[0]), 20, 1e-9);
  EXPECT_NEAR(pitch_deg(poses[10]), 10, 1e-9);
  const Eigen::Matrix3d level = CameraPoses({.kind = CameraPath::Kind::kKeyframes,
                                             .pitch_deg = 10,
                                             .keyframes = {{{1, 0}, 0}, {{2, 0}, 0}},
                                             .sway_deg = 0,
                                             .sway = 0},
                                            2, 1)[0]
                                    .linear();
  const Eigen::AngleAxisd roll(level.transpose() * poses[10].linear());
  EXPECT_NEAR(roll.angle() / kDegree, 10, 1e-9);
  EXPECT_NEAR(roll.axis().z(), -1, 1e-9);
}

TEST(CameraPath, RestsBetweenKeyframesOfOnePlace) {
  CameraPath path;
  path.kind = CameraPath::Kind::kKeyframes;
  path.sway = 0, path.sway_deg = 0;
  path.keyframes = {{{0, 0}, 0}, {{1, 0}, 0}, {{1, 0}, 40}, {{1, 0}, 40}, {{2, 1}, 0}};
  const std::vector<Isometry3d> poses = CameraPoses(path, 41, 1);
  for (size_t i = 10; i <= 30; ++i) EXPECT_EQ(poses[i].translation(), poses[10].translation());  // turns only
  for (size_t i = 20; i <= 30; ++i) EXPECT_EQ(poses[i].matrix(), poses[20].matrix());  // stands still
  EXPECT_GT(AngleBetweenDeg(HeadingDeg(poses[10]), HeadingDeg(poses[15])), 10);
  for (size_t i = 1; i < poses.size(); ++i) {  // comes to rest and starts without a jump
    EXPECT_LT((poses[i].translation() - poses[i - 1].translation()).norm(), 0.25);
  }
}

TEST(CameraPath, SwaysSlowlyAndBySeed) {
  CameraPath path = StillLoop();
  const std::vector<Isometry3d> still = CameraPoses(path, 600, 1);
  path.sway = 0.01, path.sway_deg = 1;
  const std::vector<Isometry3d> moved = CameraPoses(path, 600, 1), other = CameraPoses(path, 600, 2);
  EXPECT_GT((moved[0].translation() - other[0].translation()).norm(), 1e-4);
  EXPECT_EQ(moved[7].matrix(), CameraPoses(path, 600, 1)[7].matrix());
  double sum = 0;
  Vector3d last = Vector3d::Zero();
  for (size_t i = 0; i < moved.size(); ++i) {
    const Vector3d offset = moved[i].translation() - still[i].translation();
    if (i > 0) {
      EXPECT_LT((offset - last).norm(), 0.006);  // no white noise
    }
    sum += offset.z() * offset.z();
    last = offset;
  }
  EXPECT_NEAR(std::sqrt(sum / 600), 0.01, 0.001);
}

}  // namespace
}  // namespace armature
