// SPDX-License-Identifier: BSD-3-Clause
// Places spread evenly over the unit square, and directions over a hemisphere.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "drawing/noise.h"

namespace armature {

// Hammersley's points: no two share a row or column.
inline std::vector<Eigen::Vector2d> SpreadPlaces(int count) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < count; ++i) {
    double mirrored = 0.5 / count;  // the bits of i behind the binary point, in reverse
    for (int bits = i, k = 1; bits > 0; bits >>= 1, ++k) mirrored += (bits & 1) * std::ldexp(1.0, -k);
    places.emplace_back((i + 0.5) / count, mirrored - std::floor(mirrored));
  }
  return places;
}

// Another shift for each hash, around the square's borders: so errors of neighbours do not add up to bands.
class PlaceShift {
 public:
  explicit PlaceShift(std::uint32_t hash) : shift_(Unit(Mixed(hash)), Unit(Mixed(hash + 1))) {}

  Eigen::Vector2d operator()(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d p = place + shift_;
    return {p.x() < 1 ? p.x() : p.x() - 1, p.y() < 1 ? p.y() : p.y() - 1};
  }

 private:
  Eigen::Vector2d shift_;
};

// The third axis is the normal.
inline Eigen::Matrix3d AxesAround(const Eigen::Vector3d& normal) {
  Eigen::Matrix3d axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

// More likely where the cosine to the normal is greater, so that all directions count the same.
inline Eigen::Vector3d HemisphereDirection(const Eigen::Vector2d& place, const Eigen::Matrix3d& axes) {
  const double angle = 2 * std::numbers::pi * place.x(), radius = std::sqrt(place.y());
  return axes * Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - place.y()));
}

}  // namespace armature
