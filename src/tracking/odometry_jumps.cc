// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/odometry_jumps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/statistics.h"
#include "geometry/rotation.h"
#include "geometry/se3.h"

namespace armature {
namespace {

constexpr size_t kRecentSteps = 20, kLeastSteps = 5;
// Faster than the fastest recent step so many times: suspected; not believed unless the objects are for it.
constexpr double kSuspected = 1.5, kIncredible = 5;
constexpr double kSteadyHand = 10 * kDegree;  // radians a second, added to what was turned of late
// The objects are against what is told if they are seen so much worse than without it.
constexpr double kWorseAfterJump = 0.6, kWorseInOtherUnit = 0.88;
constexpr size_t kSpeedSteps = 5;            // before and after a change of unit that is suspected
constexpr double kSuspectedLogFactor = 0.3;  // of speed
// Shares of that: of the speeds before and after it the spread, and the change from one step to the next.
constexpr double kLargestSpread = 1, kLeastAtOnce = 0.6;
constexpr double kSuspicionSeconds = 4;  // that the objects have to tell
constexpr int kTellingFrames = 2;        // at least

}  // namespace

bool OdometryJumps::IsJump(const Motion& motion, const Eigen::Isometry3d& as_before,
                           const ObjectAgreement& agreement) const {
  if (motions_.size() < kLeastSteps) return false;
  double most_speed = 0, most_turn_rate = 0;
  for (const Motion& recent : motions_) {
    most_speed = std::max(most_speed, recent.speed);
    most_turn_rate = std::max(most_turn_rate, recent.turn_rate);
  }
  const auto is_beyond = [&](double times) {
    return motion.speed > times * most_speed || motion.turn_rate > times * (most_turn_rate + kSteadyHand);
  };
  if (!is_beyond(kSuspected)) return false;
  const std::optional<double> told = agreement(motion.T_odom_camera), before = agreement(as_before);
  if (told && before && *told != *before) return *told < kWorseAfterJump * *before;
  return is_beyond(kIncredible);
}

Eigen::Isometry3d OdometryJumps::GoOnAsBefore(double seconds) const {
  const Motion& last = motions_.back();
  if (motions_.size() < 2) return last.T_odom_camera;
  const Eigen::Isometry3d step = motions_[motions_.size() - 2].T_odom_camera.inverse() * last.T_odom_camera;
  return last.T_odom_camera * ExpSE3(seconds / last.seconds * LogSE3(step));
}

// Where the speed changed at once, from one lasting value to another. A hand that moves faster takes some
// steps to it.
std::optional<UnitChange> OdometryJumps::SuspectUnitChange() const {
  if (motions_.size() < 2 * kSpeedSteps + 1) return std::nullopt;
  const size_t change = motions_.size() - kSpeedSteps;
  std::vector<double> before, after;  // logarithms of speeds
  for (size_t k = change - kSpeedSteps; k < change; ++k) before.push_back(std::log(motions_[k].speed));
  for (size_t k = change; k < motions_.size(); ++k) after.push_back(std::log(motions_[k].speed));
  const auto [least_before, most_before] = std::minmax_element(before.begin(), before.end());
  const auto [least_after, most_after] = std::minmax_element(after.begin(), after.end());
  const double log_factor = *Quantile(after, 0.5) - *Quantile(before, 0.5);
  const double spread = std::max(*most_before - *least_before, *most_after - *least_after);
  if (!std::isfinite(log_factor) || std::abs(log_factor) < kSuspectedLogFactor) return std::nullopt;
  if (!(spread < kLargestSpread * std::abs(log_factor))) return std::nullopt;
  if ((after.front() - before.back()) / log_factor < kLeastAtOnce) return std::nullopt;
  const Motion& last_before = motions_[change - 1];
  return UnitChange{last_before.timestamp, last_before.T_odom_camera.translation(), std::exp(log_factor)};
}

std::optional<UnitChange> OdometryJumps::FindUnitChange(const ObjectAgreement& agreement) {
  const Motion& now = motions_.back();
  if (suspicion_ && now.timestamp - suspicion_->change.timestamp > kSuspicionSeconds) suspicion_.reset();
  if (!suspicion_) {
    const std::optional<UnitChange> change = SuspectUnitChange();
    if (!change) return std::nullopt;
    suspicion_ = Suspicion{*change};
  }
  const std::optional<double> told = agreement(now.T_odom_camera);
  if (!told) return std::nullopt;
  Suspicion& suspicion = *suspicion_;
  ++suspicion.frames;
  suspicion.told += *told;
  for (size_t trial = 0; trial < kFactorTrials.size(); ++trial) {
    UnitChange change = suspicion.change;
    change.factor *= kFactorTrials[trial];
    Eigen::Isometry3d T_odom_camera = now.T_odom_camera;
    T_odom_camera.translation() = change.Undo(T_odom_camera.translation());
    suspicion.undone[trial] += agreement(T_odom_camera).value_or(0);
  }
  const auto best = std::max_element(suspicion.undone.begin(), suspicion.undone.end());
  if (suspicion.frames < kTellingFrames || suspicion.told >= kWorseInOtherUnit * *best) return std::nullopt;
  UnitChange change = suspicion.change;
  change.factor *= kFactorTrials[static_cast<size_t>(best - suspicion.undone.begin())];
  return change;
}

OdometryJumps::Step OdometryJumps::Follow(double timestamp, const Eigen::Isometry3d& T_told_camera,
                                          bool is_unit_known, const ObjectAgreement& agreement) {
  Motion motion{timestamp, Eigen::Isometry3d::Identity()};
  motion.T_odom_camera.linear() = rotation_ * T_told_camera.linear();
  motion.T_odom_camera.translation() = unit_ * (rotation_ * T_told_camera.translation()) + shift_;
  Step step;
  if (!motions_.empty() && timestamp > motions_.back().timestamp) {
    motion.seconds = timestamp - motions_.back().timestamp;
    const Eigen::Isometry3d moved = motions_.back().T_odom_camera.inverse() * motion.T_odom_camera;
    motion.speed = moved.translation().norm() / motion.seconds;
    motion.turn_rate = Eigen::AngleAxisd(moved.linear()).angle() / motion.seconds;
    const Eigen::Isometry3d as_before = GoOnAsBefore(motion.seconds);
    step.is_jump = IsJump(motion, as_before, agreement);
    if (step.is_jump) {
      motion.T_odom_camera = as_before;
      motion.speed = motions_.back().speed;
      motion.turn_rate = motions_.back().turn_rate;
      rotation_ = as_before.linear() * T_told_camera.linear().transpose();
      shift_ = as_before.translation() - unit_ * (rotation_ * T_told_camera.translation());
    }
  }
  motions_.push_back(motion);
  if (motions_.size() > kRecentSteps) motions_.pop_front();
  if (is_unit_known) step.unit_change = FindUnitChange(agreement);
  if (step.unit_change) {
    const UnitChange& change = *step.unit_change;
    shift_ = change.from + (shift_ - change.from) / change.factor;
    unit_ /= change.factor;
    for (Motion& past : motions_) {
      if (past.timestamp <= change.timestamp) continue;
      past.T_odom_camera.translation() = change.Undo(past.T_odom_camera.translation());
      past.speed /= change.factor;
    }
    suspicion_.reset();
  }
  step.T_odom_camera = motions_.back().T_odom_camera;
  return step;
}

}  // namespace armature
