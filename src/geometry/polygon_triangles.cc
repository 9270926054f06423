// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/interrupt.h"

namespace armature {
namespace {

constexpr double kStraight = 1e-9;  // of the extent, or its square: how far a convex polygon may bend inwards

constexpr double kRounding = 1e-13;  // of the square of the extent: what is left of an area that is 0

using Points = std::vector<Eigen::Vector2d>;

// Newell's: twice the area, whatever the corner it starts at.
Eigen::Vector3d MeanNormal(std::span<const Eigen::Vector3d> corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return normal;
}

// As seen against the normal: the polygon turns to the left. In units of its extent.
Points Flattened(std::span<const Eigen::Vector3d> corners, const Eigen::Vector3d& normal) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& corner : corners) box.extend(corner);
  const double extent = std::max(box.diagonal().norm(), std::numeric_limits<double>::min());
  const Eigen::Vector3d z = normal.normalized(), x = z.unitOrthogonal(), y = z.cross(x);
  Points points;
  points.reserve(corners.size());
  for (const Eigen::Vector3d& corner : corners) {
    const Eigen::Vector3d from_first = (corner - corners[0]) / extent;
    points.emplace_back(x.dot(from_first), y.dot(from_first));
  }
  return points;
}

// Twice the area of the triangle, positive where it turns to the left.
double Turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Without those that stand where the one before stands: a turn at two such corners would not be seen at
// either.
Points WithoutRepeats(const Points& points) {
  Points distinct;
  for (const Eigen::Vector2d& point : points) {
    if (distinct.empty() || (point - distinct.back()).norm() > kStraight) distinct.push_back(point);
  }
  while (distinct.size() > 1 && (distinct.back() - distinct.front()).norm() <= kStraight) distinct.pop_back();
  return distinct;
}

// It turns to the left alone, and once: its edges change between forwards and backwards twice.
bool IsConvex(const Points& corners) {
  const Points points = WithoutRepeats(corners);
  int changes = 0;
  double last = 0;
  const size_t n = points.size();
  for (size_t i = 0; i < 2 * n; ++i) {
    const Eigen::Vector2d &a = points[i % n], &b = points[(i + 1) % n], &c = points[(i + 2) % n];
    if (Turn(a, b, c) < -kStraight) return false;
    const double forwards = b.x() - a.x();
    if (std::abs(forwards) <= kStraight) continue;
    if (i >= n && last * forwards < 0) ++changes;  // the first round finds the direction to begin with
    last = forwards;
  }
  return changes <= 2;
}

std::vector<TriangleCorners> Fan(size_t corners) {
  std::vector<TriangleCorners> triangles;
  for (size_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

class EarCutter {
 public:
  explicit EarCutter(const Points& points) : points_(points), next_(points.size()), previous_(points.size()) {
    for (size_t i = 0; i < points.size(); ++i) {
      next_[i] = (i + 1) % points.size();
      previous_[next_[i]] = i;
    }
  }

  std::vector<TriangleCorners> Cut() {
    size_t left = points_.size(), corner = 0, unchanged = 0;
    Strictness strictness = Strictness::kNothingTouches;
    while (left > 2) {
      if ((left & 0xFF) == 0) ThrowIfInterrupted();
      const double turn = TurnAt(corner);
      const bool is_straight = std::abs(turn) <= kRounding;
      if (is_straight || (turn > 0 && IsEar(corner, strictness))) {
        if (!is_straight) triangles_.push_back({previous_[corner], corner, next_[corner]});
        Remove(corner);
        corner = next_[next_[corner]];  // not its neighbour again, which would become a fan of slivers
        --left;
        unchanged = 0;
        strictness = Strictness::kNothingTouches;
        continue;
      }
      corner = next_[corner];
      if (++unchanged < left) continue;
      if (strictness == Strictness::kAnything) break;  // no corner turns to the left: it crosses itself
      strictness =
          strictness == Strictness::kNothingTouches ? Strictness::kNothingInside : Strictness::kAnything;
      unchanged = 0;
    }
    return std::move(triangles_);
  }

 private:
  // What an ear may have in it: nothing; what touches its border; where there is no such ear, anything.
  enum class Strictness { kNothingTouches, kNothingInside, kAnything };

  double TurnAt(size_t corner) const {
    return Turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
  }

  void Remove(size_t corner) {
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
  }

  // Another part of the border reaches into the triangle only with a corner that turns to the right. One in
  // the very place of a corner belongs to the other side of a bridge.
  bool IsEar(size_t corner, Strictness strictness) const {
    if (strictness == Strictness::kAnything) return true;
    const Eigen::Vector2d &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
    const double border = strictness == Strictness::kNothingTouches ? -kRounding : kRounding;
    for (size_t other = next_[next_[corner]]; other != previous_[corner]; other = next_[other]) {
      const Eigen::Vector2d& p = points_[other];
      const bool is_in = Turn(a, b, p) >= border && Turn(b, c, p) >= border && Turn(c, a, p) >= border;
      if (is_in && p != a && p != b && p != c && TurnAt(other) <= kRounding) return false;
    }
    return true;
  }

  const Points& points_;
  std::vector<size_t> next_, previous_;
  std::vector<TriangleCorners> triangles_;
};

}  // namespace

std::vector<TriangleCorners> CutPolygon(std::span<const Eigen::Vector3d> corners) {
  if (corners.size() < 4) return Fan(corners.size());
  const Eigen::Vector3d normal = MeanNormal(corners);
  if (!(normal.norm() > 0)) return Fan(corners.size());  // no area to lose
  const Points points = Flattened(corners, normal);
  if (IsConvex(points)) return Fan(corners.size());
  if (corners.size() > kMostConcaveCorners) return {};
  return EarCutter(points).Cut();
}

}  // namespace armature
