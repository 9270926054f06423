// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/odometry_unit.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

// Of cameras in rooms, metres a second, and the standard deviation of its logarithm. The videos at hand have
// 0.25 to 1, but too slow is the safe side: tracks then follow the camera's rotation, and are lost to one
// that is believed to travel where it does not.
const double kLogSpeed = std::log(0.08);
constexpr double kLogSpeedSigma = 3;
constexpr double kWaypointSeconds = 1;  // between positions that the way is measured by: trembling is no way
constexpr double kFadingOfUnits = 0.995;  // weight of what was known before, with each new observation

}  // namespace

void OdometryUnit::Follow(double timestamp, const Eigen::Isometry3d& T_odom_camera) {
  if (is_metric_) return;
  if (!waypoint_) waypoint_ = {timestamp, T_odom_camera.translation()};
  const double travelled = travelled_ + (T_odom_camera.translation() - waypoint_->position).norm();
  const double seconds = seconds_ + std::max(0.0, timestamp - waypoint_->timestamp);
  if (timestamp - waypoint_->timestamp >= kWaypointSeconds) {
    travelled_ = travelled;
    seconds_ = seconds;
    waypoint_ = {timestamp, T_odom_camera.translation()};
  }
  if (travelled <= 0 || seconds <= 0) return;
  if (is_by_speed_) MoveGuess(std::log(travelled / seconds) - kLogSpeed);
}

void OdometryUnit::Guess(double log_units) {
  if (is_metric_) return;
  is_by_speed_ = false;
  MoveGuess(log_units);
}

void OdometryUnit::MoveGuess(double log_units) {
  if (information_ == 0) {  // the first motion
    information_ = guess_information_ = 1 / (kLogSpeedSigma * kLogSpeedSigma);
    log_units_ = log_units;
  } else {
    log_units_ += guess_information_ / information_ * (log_units - guess_);
  }
  guess_ = log_units;
  Update();
}

void OdometryUnit::Learn(double error, double slope, double variance) {
  if (is_metric_ || information_ == 0) return;
  const double gained = slope * slope / (variance * (1 + error * error / (6 * variance)));
  guess_information_ *= kFadingOfUnits;
  information_ = kFadingOfUnits * information_ + gained;
  log_units_ -= gained / information_ * error / std::max(slope, 0.05);
}

void OdometryUnit::Update() { units_ = std::exp(log_units_); }

ScaleEstimate OdometryUnit::Scale() const {
  if (is_metric_) return {1, 0};
  if (information_ == 0) return {};
  return {1 / units_, 1 / std::sqrt(information_)};
}

}  // namespace armature
