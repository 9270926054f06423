// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/timed_pose.h"

#include <algorithm>
#include <cmath>

namespace armature {

std::optional<size_t> FindStamp(const std::vector<TimedPose>& poses, double timestamp, double tolerance) {
  const auto later = std::lower_bound(poses.begin(), poses.end(), timestamp,
                                      [](const TimedPose& pose, double t) { return pose.timestamp < t; });
  auto nearest = later;
  if (later == poses.end() ||
      (later != poses.begin() && timestamp - (later - 1)->timestamp < later->timestamp - timestamp)) {
    if (later == poses.begin()) return std::nullopt;
    nearest = later - 1;
  }
  if (std::abs(nearest->timestamp - timestamp) > tolerance + kStampRounding) return std::nullopt;
  return static_cast<size_t>(nearest - poses.begin());
}

}  // namespace armature
