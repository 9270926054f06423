// SPDX-License-Identifier: BSD-3-Clause
// Axis-aligned boxes in the image.
#pragma once

#include <Eigen/Core>

namespace armature {

struct Box {
  double x = 0, y = 0;           // top-left corner, pixels
  double width = 0, height = 0;  // pixels

  double left() const { return x; }
  double top() const { return y; }
  double right() const { return x + width; }
  double bottom() const { return y + height; }
  double area() const { return width * height; }
  Eigen::Vector2d center() const { return {x + width / 2, y + height / 2}; }
  bool Contains(const Eigen::Vector2d& p) const {
    return p.x() >= left() && p.x() <= right() && p.y() >= top() && p.y() <= bottom();
  }
  Box Grown(double pixels) const { return {x - pixels, y - pixels, width + 2 * pixels, height + 2 * pixels}; }
};

// The overlap of two boxes; width and height are 0 where they are apart.
Box Intersection(const Box& a, const Box& b);

// Area of the intersection over area of the union, 0 for two empty boxes.
double IntersectionOverUnion(const Box& a, const Box& b);

}  // namespace armature
