// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/odometry_losses.h"

#include <cmath>
#include <numbers>

#include "datasets/simulation/stretches.h"
#include "geometry/random.h"

namespace armature {
namespace {

// As a person's head or a hand turns: on a circle smaller than this, metres.
constexpr double kTurnRadius = 0.2;

// The angle of a motion about the camera itself, radians; 0: it moves as well.
double TurnInPlace(const Eigen::Isometry3d& motion) {
  const double angle = Eigen::AngleAxisd(motion.linear()).angle();
  return motion.translation().norm() < kTurnRadius * angle ? angle : 0;
}

}  // namespace

std::vector<bool> LostImages(size_t images, double fps, const OdometryNoise& noise, std::uint64_t seed) {
  std::vector<bool> lost(images, false);
  Random random(seed);
  Stretches stretches;
  for (size_t i = 1; i < images; ++i) {
    const double time = static_cast<double>(i) / fps;
    lost[i] = noise.lost_at ? time >= *noise.lost_at && time < *noise.lost_at + noise.lost_seconds
                            : stretches.IsOn(noise.lost_share, noise.lost_seconds, time, random);
  }
  return lost;
}

std::vector<double> ScaleFactors(const std::vector<Eigen::Isometry3d>& T_world_camera,
                                 const std::vector<bool>& lost, const OdometryNoise& noise,
                                 std::uint64_t seed) {
  std::vector<double> factors;
  Random random(seed);
  double factor = 1;
  for (size_t i = 0; i + 1 < T_world_camera.size(); ++i) {
    const double turned = TurnInPlace(T_world_camera[i].inverse() * T_world_camera[i + 1]);
    const double drift = noise.turn_scale_drift * std::sqrt(turned / (std::numbers::pi / 2));
    factor *= std::exp(random.Normal(0, drift));
    const bool is_up = random.Uniform(0, 1) < 0.5;
    if (i > 0 && lost[i - 1] && !lost[i]) factor *= is_up ? 1 + noise.scale_jump : 1 / (1 + noise.scale_jump);
    factors.push_back(factor);
  }
  return factors;
}

}  // namespace armature
