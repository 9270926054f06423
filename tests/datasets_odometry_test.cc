// SPDX-License-Identifier: BSD-3-Clause
// The simulated odometry: what it corrupts, and by how much.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "datasets/simulation/odometry.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr OdometryNoise kExactOdometry{
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

double Length(const std::vector<Eigen::Isometry3d>& poses, size_t i) {
  return (poses[i + 1].translation() - poses[i].translation()).norm();
}

TEST(SimulatedOdometry, WithoutNoiseIsTheTruthSeenFromTheFirstCamera) {
  const auto truth = StraightFlight(5);
  const auto odometry = SimulateOdometry(truth, kExactOdometry, 1);
  for (size_t i = 0; i < truth.size(); ++i)
    EXPECT_TRUE(odometry[i].isApprox(truth.front().inverse() * truth[i], 1e-12)) << i;
}

TEST(SimulatedOdometry, ScaleDriftsFromTheFirstMotionToTheLast) {
  OdometryNoise noise = kExactOdometry;
  noise.scale = 0.4;
  noise.scale_drift = 0.21;
  const auto odometry = SimulateOdometry(StraightFlight(4), noise, 1);
  EXPECT_NEAR(Length(odometry, 0), 0.4, 1e-12);
  EXPECT_NEAR(Length(odometry, 1), 0.4 * 1.1, 1e-12);
  EXPECT_NEAR(Length(odometry, 2), 0.4 * 1.21, 1e-12);
}

TEST(SimulatedOdometry, HeadingDriftsAboutTheVerticalAlone) {
  OdometryNoise noise = kExactOdometry;
  noise.heading_drift_deg = 6;
  const auto truth = StraightFlight(31);
  const auto odometry = SimulateOdometry(truth, noise, 1);
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
  const auto odometry = SimulateOdometry(truth, noise, 5);
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
  for (const Eigen::Isometry3d& pose : SimulateOdometry(turn, OdometryNoise(), 3))
    EXPECT_EQ(pose.translation().norm(), 0);
}

TEST(SimulatedOdometry, DependsOnTheSeedAlone) {
  const auto truth = StraightFlight(5);
  const auto a = SimulateOdometry(truth, OdometryNoise(), 1), b = SimulateOdometry(truth, OdometryNoise(), 1),
             c = SimulateOdometry(truth, OdometryNoise(), 2);
  EXPECT_EQ(a.back().matrix(), b.back().matrix());
  EXPECT_NE(a.back().matrix(), c.back().matrix());
}

}  // namespace
}  // namespace armature
