// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/far_start.h"

#include <algorithm>

namespace armature {
namespace {

constexpr double kFar = 100;  // of the poses' extent; Ceres' steps end at 1e-6 of it then

}  // namespace

std::optional<Eigen::Vector3d> FindFarStart(const std::vector<Eigen::Isometry3d>& poses) {
  if (poses.empty()) return std::nullopt;
  const Eigen::Vector3d start = poses.front().translation();
  double extent = 0;
  for (const Eigen::Isometry3d& pose : poses) extent = std::max(extent, (pose.translation() - start).norm());
  if (start.norm() <= kFar * extent) return std::nullopt;
  return start;
}

}  // namespace armature
