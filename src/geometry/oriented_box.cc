// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace armature {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;  // flat and convex, in order around it
using Polyhedron = std::vector<Polygon>;       // convex: its faces

// The points x with normal . x <= offset.
struct HalfSpace {
  Eigen::Vector3d normal;  // unit length
  double offset;

  double Outside(const Eigen::Vector3d& x) const { return normal.dot(x) - offset; }
};

// The box's faces in the frame that T_frame_world leads to.
Polyhedron MakeFaces(const OrientedBox& box, const Eigen::Isometry3d& T_frame_world) {
  const Eigen::Isometry3d T_frame_box = T_frame_world * box.T_world_box;
  const double around[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  Polyhedron faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      Polygon& face = faces.emplace_back();
      for (const auto& corner : around) {
        Eigen::Vector3d unit;
        unit[axis] = side, unit[(axis + 1) % 3] = corner[0], unit[(axis + 2) % 3] = corner[1];
        face.push_back(T_frame_box * unit.cwiseProduct(box.size));
      }
    }
  }
  return faces;
}

// What of the face is inside; the points where its outline crosses the plane are added to `crossings`.
Polygon Clipped(const Polygon& face, const HalfSpace& space, Polygon& crossings) {
  Polygon kept;
  for (size_t i = 0; i < face.size(); ++i) {
    const Eigen::Vector3d &a = face[i], &b = face[(i + 1) % face.size()];
    const double outside_a = space.Outside(a), outside_b = space.Outside(b);
    if (outside_a <= 0) kept.push_back(a);
    if ((outside_a <= 0) == (outside_b <= 0)) continue;
    kept.push_back(a + outside_a / (outside_a - outside_b) * (b - a));
    crossings.push_back(kept.back());
  }
  return kept;
}

Eigen::Vector3d Mean(const Polygon& points) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

// Corners of a convex polygon with the normal, put in order around it.
void SortAround(const Eigen::Vector3d& normal, Polygon& corners) {
  const Eigen::Vector3d centre = Mean(corners), u = normal.unitOrthogonal(), v = normal.cross(u);
  const auto angle = [&](const Eigen::Vector3d& x) {
    return std::atan2(v.dot(x - centre), u.dot(x - centre));
  };
  std::sort(corners.begin(), corners.end(),
            [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return angle(a) < angle(b); });
}

Polyhedron Clipped(const Polyhedron& solid, const HalfSpace& space) {
  Polyhedron kept;
  Polygon cut;  // the new face in the plane
  for (const Polygon& face : solid) {
    Polygon rest = Clipped(face, space, cut);
    if (rest.size() >= 3) kept.push_back(std::move(rest));
  }
  if (cut.size() >= 3) {
    SortAround(space.normal, cut);
    kept.push_back(std::move(cut));
  }
  return kept;
}

// The sum of the pyramids over the faces from a point inside.
double Volume(const Polyhedron& solid) {
  Polygon corners;
  for (const Polygon& face : solid) corners.insert(corners.end(), face.begin(), face.end());
  if (corners.empty()) return 0;
  const Eigen::Vector3d inside = Mean(corners);
  double volume = 0;
  for (const Polygon& face : solid) {
    const Eigen::Vector3d first = face[0] - inside;
    for (size_t i = 1; i + 1 < face.size(); ++i) {
      volume += std::abs(first.dot((face[i] - inside).cross(face[i + 1] - inside))) / 6;
    }
  }
  return volume;
}

}  // namespace

double IntersectionVolume(const OrientedBox& a, const OrientedBox& b) {
  Polyhedron rest = MakeFaces(a, b.T_world_box.inverse());  // in the frame of b
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      rest = Clipped(rest, {sign * Eigen::Vector3d::Unit(axis), b.size[axis] / 2});
    }
  }
  return Volume(rest);
}

double IntersectionOverUnion(const OrientedBox& a, const OrientedBox& b) {
  const double common = IntersectionVolume(a, b);
  const double both = a.volume() + b.volume() - common;
  return both > 0 ? std::clamp(common / both, 0.0, 1.0) : 0;
}

}  // namespace armature
