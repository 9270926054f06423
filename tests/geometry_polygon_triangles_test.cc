// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/polygon_triangles.h"

namespace armature {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

Polygon Flat(const std::vector<Eigen::Vector2d>& points) {
  Polygon polygon;
  for (const Eigen::Vector2d& point : points) polygon.emplace_back(point.x(), point.y(), 0);
  return polygon;
}

// Sum of the triangles' vectors, each with its own direction: no two may overlap or be turned for the lengths
// to add up to that of the sum.
struct PolygonArea {
  Eigen::Vector3d sum{0, 0, 0};
  double lengths = 0;
};

PolygonArea Area(const Polygon& polygon) {
  PolygonArea area;
  for (const TriangleCorners& t : CutPolygon(polygon)) {
    const Eigen::Vector3d cross = (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]) / 2;
    area.sum += cross;
    area.lengths += cross.norm();
  }
  return area;
}

void ExpectArea(const Polygon& polygon, double expected) {
  Polygon turned = polygon, reversed(polygon.rbegin(), polygon.rend());
  for (size_t first = 0; first < polygon.size(); ++first) {
    EXPECT_NEAR(Area(turned).lengths, expected, 1e-12) << "from corner " << first;
    EXPECT_NEAR(Area(turned).sum.z(), expected, 1e-12) << "from corner " << first;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  EXPECT_NEAR(Area(reversed).lengths, expected, 1e-12);
  EXPECT_NEAR(Area(reversed).sum.z(), -expected, 1e-12);  // keeps its direction
}

TEST(CutPolygon, ConvexOnesAreAFanAroundTheFirstCorner) {
  const Polygon square = Flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(CutPolygon(square), (std::vector<TriangleCorners>{{0, 1, 2}, {0, 2, 3}}));
  Polygon circle;
  for (int i = 0; i < 5000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 5000;
    circle.emplace_back(std::cos(angle), 3, std::sin(angle));
  }
  const auto triangles = CutPolygon(circle);
  ASSERT_EQ(triangles.size(), 4998u);
  EXPECT_EQ(triangles[4000], (TriangleCorners{0, 4001, 4002}));
}

TEST(CutPolygon, ConcaveOnesKeepTheirArea) {
  ExpectArea(Flat({{0.5, 0}, {0, 0}, {0, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}}), 0.75);  // an L
  ExpectArea(Flat({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}), 8);         // a U
  ExpectArea(Flat({{0, 0}, {2, 1}, {4, 0}, {2, 4}}), 6);                                         // an arrow
  Polygon star;
  for (int i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi * i / 5, radius = i % 2 == 0 ? 2 : 1;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  ExpectArea(star, 10 * std::sin(std::numbers::pi / 5));
}

TEST(CutPolygon, CornersInALineOrTwiceInAPlaceLoseNothing) {
  ExpectArea(Flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0.5, 1}, {0, 1}}), 3);
  ExpectArea(Flat({{0, 0}, {2, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {1, 1}, {0, 1}}), 3);
  ExpectArea(Flat({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}}), 1);
}

TEST(CutPolygon, ABridgeToAHoleLeavesTheHole) {
  ExpectArea(Flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}), 8);
}

TEST(CutPolygon, QuadsOutOfAPlaneAreCutAsTheyAreSeen) {
  const Polygon bent{{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.1}};
  EXPECT_EQ(CutPolygon(bent), (std::vector<TriangleCorners>{{0, 1, 2}, {0, 2, 3}}));
  const Polygon arrow{{0, 0, 0.1}, {2, 1, 0}, {4, 0, 0.1}, {2, 4, 0}};
  EXPECT_NEAR(Area(arrow).sum.z(), 6, 1e-12);
  for (const TriangleCorners& t : CutPolygon(arrow))
    EXPECT_TRUE(std::find(t.begin(), t.end(), 1u) != t.end()) << "must be cut at the corner that points in";
}

TEST(CutPolygon, InAnyPlaceDirectionAndSize) {
  const Polygon l = Flat({{0.5, 0}, {0, 0}, {0, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}});
  for (const double size : {1e-6, 1e3}) {
    const Eigen::Affine3d T = Eigen::Translation3d(100 * size, 0, 7 * size) *
                              Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()) *
                              Eigen::Scaling(size);
    Polygon moved;
    for (const Eigen::Vector3d& corner : l) moved.push_back(T * corner);
    EXPECT_NEAR(Area(moved).lengths / (size * size), 0.75, 1e-9);
  }
}

TEST(CutPolygon, WhatCrossesItselfOrHasNoAreaEnds) {
  CutPolygon(Flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));  // a bow
  CutPolygon(Flat({{0, 0}, {2, 0}, {0, 1}, {2, 1}, {1, -1}}));
  CutPolygon(Flat({{0, 0}, {0, 0}, {0, 0}, {0, 0}}));
  CutPolygon(Flat({{0, 0}, {1, 0}, {2, 0}, {1, 0}}));
  CutPolygon(Polygon{{1e300, 0, 0}, {0, 1e300, 0}, {-1e300, 0, 0}, {0, -1e300, 1e300}});
}

TEST(CutPolygon, TooManyCornersAreNotCut) {
  Polygon comb;
  for (int i = 0; i < 3000; ++i) {
    comb.emplace_back(i, 0, 0);
    comb.emplace_back(i + 0.5, i % 2, 0);
  }
  comb.emplace_back(3000, -1, 0);
  comb.emplace_back(0, -1, 0);
  EXPECT_TRUE(CutPolygon(comb).empty());
}

}  // namespace
}  // namespace armature
