// SPDX-License-Identifier: BSD-3-Clause
// Whether a part is a solid: closed, and its quads seen from outside.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "drawing/mesh.h"

namespace armature::testing {

// By the divergence theorem, cubic metres; negative where the quads are inside out.
inline double Volume(const Part& part) {
  double volume = 0;
  for (const Quad& quad : part.quads) {
    const auto& [a, b, c, d] = quad.corners;
    volume += (a.dot(b.cross(c)) + a.dot(c.cross(d))) / 6;
  }
  return volume;
}

// Whether every side of a quad is the side of another one in the opposite direction.
inline bool IsClosed(const Part& part) {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> sides;
  for (const Quad& quad : part.quads) {
    for (size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d &from = quad.corners[i], &to = quad.corners[(i + 1) % 4];
      if (from != to) sides.emplace_back(from, to);
    }
  }
  for (const auto& [from, to] : sides) {
    int opposite = 0;
    for (const auto& [other_from, other_to] : sides) opposite += other_from == to && other_to == from;
    if (opposite != 1) return false;
  }
  return true;
}

}  // namespace armature::testing
