// SPDX-License-Identifier: BSD-3-Clause
#include "odometry/odometry.h"

#include <algorithm>

namespace armature {
namespace {

std::optional<Eigen::Isometry3d> Interpolated(const std::vector<TimedPose>& odometry, double timestamp,
                                              double max_gap) {
  const auto after = std::upper_bound(odometry.begin(), odometry.end(), timestamp,
                                      [](double t, const TimedPose& pose) { return t < pose.timestamp; });
  if (after == odometry.begin() || after == odometry.end()) return std::nullopt;
  const auto before = after - 1;
  if (after->timestamp - before->timestamp > max_gap + kStampRounding) return std::nullopt;
  return InterpolatePose(*before, *after, timestamp);
}

void CountGaps(const std::vector<double>& stamps, OdometryAtImages& at_images) {
  const auto& poses = at_images.T_odom_camera;
  OdometryCoverage& coverage = at_images.coverage;
  for (size_t i = 0; i < poses.size(); ++i) {
    if (poses[i] || (i > 0 && !poses[i - 1])) continue;  // not the first of a gap
    const auto end = std::find_if(poses.begin() + static_cast<std::ptrdiff_t>(i), poses.end(),
                                  [](const auto& pose) { return pose.has_value(); });
    const auto next = static_cast<size_t>(end - poses.begin());
    const double from = stamps[i == 0 ? 0 : i - 1], to = stamps[std::min(next, poses.size() - 1)];
    ++coverage.gaps;
    coverage.longest_gap = std::max(coverage.longest_gap, to - from);
  }
}

}  // namespace

Eigen::Isometry3d InterpolatePose(const TimedPose& before, const TimedPose& after, double timestamp) {
  const double share = (timestamp - before.timestamp) / (after.timestamp - before.timestamp);
  const Eigen::Quaterniond q0(before.pose.linear()), q1(after.pose.linear());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = q0.slerp(share, q1).normalized().toRotationMatrix();
  pose.translation() = (1 - share) * before.pose.translation() + share * after.pose.translation();
  return pose;
}

OdometryAtImages PosesAtImages(const std::vector<TimedPose>& odometry, const std::vector<double>& stamps,
                               const OdometryOptions& options) {
  OdometryAtImages result;
  OdometryCoverage& coverage = result.coverage;
  coverage.poses = static_cast<int>(odometry.size());
  coverage.images = static_cast<int>(stamps.size());
  for (const double stamp : stamps) {
    std::optional<Eigen::Isometry3d> pose;
    if (const auto index = FindStamp(odometry, stamp, options.tolerance)) {
      pose = odometry[*index].pose;
    } else {
      pose = Interpolated(odometry, stamp, options.max_gap);
      coverage.interpolated += pose ? 1 : 0;
    }
    coverage.images_with_pose += pose ? 1 : 0;
    result.T_odom_camera.push_back(pose);
  }
  CountGaps(stamps, result);
  return result;
}

}  // namespace armature
