// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/odometry.h"

#include <cmath>

#include "datasets/simulation/odometry_losses.h"
#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

Eigen::Vector3d NormalVector(double sigma, Random& random) {
  Eigen::Vector3d v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = random.Normal(0, sigma);
  return v;
}

// Streams of random numbers beside the one of the noise.
enum OdometryStream : std::uint64_t { kLosses = 1, kScaleFactors };

// Without losses.
std::vector<Eigen::Isometry3d> Corrupted(const std::vector<Eigen::Isometry3d>& T_world_camera,
                                         const std::vector<double>& scale_factors, const OdometryNoise& noise,
                                         std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Isometry3d> T_odom_camera(T_world_camera.size(), Eigen::Isometry3d::Identity());
  const double motions = static_cast<double>(T_world_camera.size()) - 1;
  for (size_t i = 0; i + 1 < T_world_camera.size(); ++i) {
    Eigen::Isometry3d motion = T_world_camera[i].inverse() * T_world_camera[i + 1];
    const double done = motions > 1 ? static_cast<double>(i) / (motions - 1) : 0;
    const double scale = scale_factors[i] * noise.scale * std::pow(1 + noise.scale_drift, done);
    const double length = motion.translation().norm();
    motion.translation() =
        scale * (motion.translation() + NormalVector(noise.translation_noise * length, random));
    const Eigen::Vector3d up_camera = T_world_camera[i + 1].linear().transpose() * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d turn = noise.heading_drift_deg * kDegree / motions * up_camera;
    motion.linear() =
        (motion.linear() * ExpSO3(turn) * ExpSO3(NormalVector(noise.rotation_noise_deg * kDegree, random)))
            .eval();
    T_odom_camera[i + 1] = T_odom_camera[i] * motion;
  }
  return T_odom_camera;
}

}  // namespace

std::vector<std::optional<Eigen::Isometry3d>> SimulateOdometry(
    const std::vector<Eigen::Isometry3d>& T_world_camera, double fps, const OdometryNoise& noise,
    std::uint64_t seed) {
  std::vector<std::optional<Eigen::Isometry3d>> found(T_world_camera.size());
  if (noise.kind == OdometryKind::kNone) return found;
  const std::vector<bool> lost = LostImages(found.size(), fps, noise, StreamSeed(seed, kLosses));
  const std::vector<double> factors =
      ScaleFactors(T_world_camera, lost, noise, StreamSeed(seed, kScaleFactors));
  const std::vector<Eigen::Isometry3d> T_odom_camera = Corrupted(T_world_camera, factors, noise, seed);
  for (size_t i = 0; i < found.size(); ++i) {
    if (!lost[i]) found[i] = T_odom_camera[i];
  }
  return found;
}

}  // namespace armature
