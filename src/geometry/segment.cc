// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace armature {

// Liang-Barsky: each side of the box cuts the interval [enter, leave] of the parameter along p1 -> p2.
std::optional<Segment> Clipped(const Segment& segment, const Box& box) {
  const Eigen::Vector2d d = segment.p2 - segment.p1;
  const double step[4] = {-d.x(), d.x(), -d.y(), d.y()};
  const double room[4] = {segment.p1.x() - box.left(), box.right() - segment.p1.x(),
                          segment.p1.y() - box.top(), box.bottom() - segment.p1.y()};
  double enter = 0, leave = 1;
  for (int side = 0; side < 4; ++side) {
    if (step[side] == 0) {
      if (room[side] < 0) return std::nullopt;
    } else if (step[side] < 0) {
      enter = std::max(enter, room[side] / step[side]);
    } else {
      leave = std::min(leave, room[side] / step[side]);
    }
  }
  if (enter >= leave) return std::nullopt;
  return Segment{segment.p1 + enter * d, segment.p1 + leave * d};
}

double SignedDistanceToLine(const Segment& line, const Eigen::Vector2d& point) {
  const Eigen::Vector2d d = (line.p2 - line.p1).normalized();
  const Eigen::Vector2d v = point - line.p1;
  return d.x() * v.y() - d.y() * v.x();
}

double AcuteAngle(const Segment& a, const Segment& b) {
  const Eigen::Vector2d u = a.p2 - a.p1, v = b.p2 - b.p1;
  return std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), std::abs(u.dot(v)));
}

}  // namespace armature
