// SPDX-License-Identifier: BSD-3-Clause
// Line segments in the image.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/box.h"

namespace armature {

struct Segment {
  Eigen::Vector2d p1{0, 0};  // pixels
  Eigen::Vector2d p2{0, 0};  // pixels

  Eigen::Vector2d middle() const { return 0.5 * (p1 + p2); }
  double length() const { return (p2 - p1).norm(); }
};

// The part of the segment inside the box, none if it is outside.
std::optional<Segment> Clipped(const Segment& segment, const Box& box);

// Distance of a point from the infinite line through the segment, signed: positive to the right of p1 -> p2
// (y down).
double SignedDistanceToLine(const Segment& line, const Eigen::Vector2d& point);

// The acute angle between two segments, in [0, pi/2] radians.
double AcuteAngle(const Segment& a, const Segment& b);

}  // namespace armature
