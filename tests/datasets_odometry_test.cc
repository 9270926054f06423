// SPDX-License-Identifier: BSD-3-Clause
// The simulated odometry: what it corrupts, and by how much.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "datasets/simulation/odometry.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

const OdometryNoise kExactOdometry{
    .scale = 1, .scale_drift = 0, .heading_drift_deg = 0, .translation_noise = 0, .rotation_noise_deg = 0};

// A level camera at 1.4 m that looks along the world's x and flies along y, a metre a frame.
std::vector<Eigen::Isometry3d> StraightFlight(int frames) {
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < frames; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    pose.translation() = Eigen::Vector3d(3, i, 1.4);
    poses.push_back(pose);
  }
  return poses;
}

// Of an image a second, none of them lost.
std::vector<Eigen::Isometry3d> Poses(const std::vector<Eigen::Isometry3d>& truth, const OdometryNoise& noise,
                                     std::uint64_t seed) {
  std::vector<Eigen::Isometry3d> poses;
  for (const auto& pose : SimulateOdometry(truth, 1, noise, seed)) poses.push_back(pose.value());
  return poses;
}

double Length(const std::vector<Eigen::Isometry3d>& poses, size_t i) {
  return (poses[i + 1].translation() - poses[i].translation()).norm();
}

TEST(SimulatedOdometry, WithoutNoiseIsTheTruthSeenFromTheFirstCamera) {
  const auto truth = StraightFlight(5);
  const auto odometry = Poses(truth, kExactOdometry, 1);
  for (size_t i = 0; i < truth.size(); ++i)
    EXPECT_TRUE(odometry[i].isApprox(truth.front().inverse() * truth[i], 1e-12)) << i;
}

TEST(SimulatedOdometry, ScaleDriftsFromTheFirstMotionToTheLast) {
  OdometryNoise noise = kExactOdometry;
  noise.scale = 0.4;
  noise.scale_drift = 0.21;
  const auto odometry = Poses(StraightFlight(4), noise, 1);
  EXPECT_NEAR(Length(odometry, 0), 0.4, 1e-12);
  EXPECT_NEAR(Length(odometry, 1), 0.4 * 1.1, 1e-12);
  EXPECT_NEAR(Length(odometry, 2), 0.4 * 1.21, 1e-12);
}

TEST(SimulatedOdometry, HeadingDriftsAboutTheVerticalAlone) {
  OdometryNoise noise = kExactOdometry;
  noise.heading_drift_deg = 6;
  const auto truth = StraightFlight(31);
  const auto odometry = Poses(truth, noise, 1);
  const Eigen::Matrix3d R_world_odom = truth.front().linear();
  const Eigen::Matrix3d R_world_camera = R_world_odom * odometry.back().linear();
  EXPECT_TRUE((R_world_camera * truth.back().linear().transpose())
                  .isApprox(ExpSO3(Eigen::Vector3d(0, 0, 6 * kDegree)), 1e-12));
  // Each motion is along the drifted heading, a metre long.
  EXPECT_NEAR(Length(odometry, 29), 1, 1e-12);
  EXPECT_LT((R_world_odom * odometry.back().translation()).x(), -1);
}

TEST(SimulatedOdometry, NoiseHasItsSigmas) {
  OdometryNoise noise = kExactOdometry;
  noise.translation_noise = 0.02;
  noise.rotation_noise_deg = 0.1;
  const auto truth = StraightFlight(2001);
  const auto odometry = Poses(truth, noise, 5);
  double shift = 0, turn = 0;
  for (size_t i = 0; i + 1 < truth.size(); ++i) {
    const Eigen::Isometry3d error =
        (truth[i].inverse() * truth[i + 1]).inverse() * (odometry[i].inverse() * odometry[i + 1]);
    shift += error.translation().squaredNorm() / 3;
    turn += LogSO3(error.linear()).squaredNorm() / 3;
  }
  EXPECT_NEAR(std::sqrt(shift / 2000), 0.02, 0.001);
  EXPECT_NEAR(std::sqrt(turn / 2000) / kDegree, 0.1, 0.005);
}

TEST(SimulatedOdometry, ATurnInPlaceHasNoTranslation) {
  std::vector<Eigen::Isometry3d> turn(10, Eigen::Isometry3d::Identity());
  for (size_t i = 0; i < turn.size(); ++i) turn[i].linear() = ExpSO3(Eigen::Vector3d(0, 0, 0.1 * double(i)));
  for (const Eigen::Isometry3d& pose : Poses(turn, OdometryNoise(), 3))
    EXPECT_EQ(pose.translation().norm(), 0);
}

TEST(SimulatedOdometry, DependsOnTheSeedAlone) {
  const auto truth = StraightFlight(5);
  const auto a = Poses(truth, OdometryNoise(), 1), b = Poses(truth, OdometryNoise(), 1),
             c = Poses(truth, OdometryNoise(), 2);
  EXPECT_EQ(a.back().matrix(), b.back().matrix());
  EXPECT_NE(a.back().matrix(), c.back().matrix());
}

TEST(SimulatedOdometry, IsLostWhereItIsToldToBe) {
  OdometryNoise noise = kExactOdometry;
  noise.lost_at = 3;
  noise.lost_seconds = 2;
  const auto truth = StraightFlight(8);
  const auto odometry = SimulateOdometry(truth, 1, noise, 1);
  for (size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(odometry[i].has_value(), i != 3 && i != 4) << i;
    if (odometry[i]) {
      EXPECT_TRUE(odometry[i]->isApprox(truth.front().inverse() * truth[i], 1e-12)) << i;
    }
  }
}

TEST(SimulatedOdometry, TheScaleJumpsAfterALostStretch) {
  OdometryNoise noise = kExactOdometry;
  noise.lost_at = 3;
  noise.lost_seconds = 2;
  noise.scale_jump = 0.5;
  int up = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto odometry = SimulateOdometry(StraightFlight(9), 1, noise, seed);
    const auto length = [&](size_t i) {
      return (odometry[i + 1]->translation() - odometry[i]->translation()).norm();
    };
    EXPECT_NEAR(length(1), 1, 1e-12);
    EXPECT_NEAR((odometry[5]->translation() - odometry[2]->translation()).norm(), 3, 1e-12);
    const bool is_up = length(5) > 1;
    EXPECT_NEAR(length(5), is_up ? 1.5 : 1 / 1.5, 1e-12);
    EXPECT_NEAR(length(7), length(5), 1e-12);
    up += is_up ? 1 : 0;
  }
  EXPECT_GT(up, 8);
  EXPECT_LT(up, 32);
}

TEST(SimulatedOdometry, IsLostForItsShareOfTheTime) {
  OdometryNoise noise = kExactOdometry;
  noise.lost_share = 0.2;
  noise.lost_seconds = 5;
  const auto odometry = SimulateOdometry(StraightFlight(20000), 1, noise, 1);
  EXPECT_TRUE(odometry.front());
  int lost = 0, stretches = 0;
  for (size_t i = 1; i < odometry.size(); ++i) {
    lost += odometry[i] ? 0 : 1;
    stretches += !odometry[i] && odometry[i - 1] ? 1 : 0;
  }
  EXPECT_NEAR(lost / 20000.0, 0.2, 0.03);
  EXPECT_NEAR(static_cast<double>(lost) / stretches, 5.5, 0.6);
}

TEST(SimulatedOdometry, OfNoKindHasNoPoses) {
  OdometryNoise noise = kExactOdometry;
  noise.kind = OdometryKind::kNone;
  for (const auto& pose : SimulateOdometry(StraightFlight(3), 1, noise, 1)) EXPECT_FALSE(pose);
}

// Flies a metre, turns by a right angle in place, and flies a metre.
std::vector<Eigen::Isometry3d> FlightWithATurn() {
  std::vector<Eigen::Isometry3d> poses = StraightFlight(2);
  for (const double part : {0.5, 1.0}) {
    poses.push_back(poses[1]);
    poses.back().linear() = ExpSO3(Eigen::Vector3d(0, 0, 90 * kDegree * part)) * poses[1].linear();
  }
  poses.push_back(poses.back());
  poses.back().translation().y() += 1;
  return poses;
}

TEST(SimulatedOdometry, TheScaleDriftsMoreWhereTheCameraOnlyTurns) {
  OdometryNoise noise = kExactOdometry;
  noise.turn_scale_drift = 0.2;
  double squares = 0;
  constexpr int kSeeds = 2000;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto odometry = Poses(FlightWithATurn(), noise, seed);
    EXPECT_NEAR(Length(odometry, 0), 1, 1e-12);
    squares += std::pow(std::log(Length(odometry, 3)), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / kSeeds), 0.2, 0.01);
}

}  // namespace
}  // namespace armature
