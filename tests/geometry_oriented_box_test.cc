// SPDX-License-Identifier: BSD-3-Clause
// Common volumes of boxes: known ones, and random ones against counting random points.
#include <gtest/gtest.h>

#include <random>

#include "geometry/oriented_box.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

OrientedBox BoxAt(const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
                  const Eigen::Vector3d& rotation = {0, 0, 0}) {
  OrientedBox box;
  box.T_world_box.linear() = ExpSO3(rotation);
  box.T_world_box.translation() = centre;
  box.size = size;
  return box;
}

bool Contains(const OrientedBox& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d x = box.T_world_box.inverse() * point;
  return (x.cwiseAbs() - box.size / 2).maxCoeff() <= 0;
}

OrientedBox RandomBox(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Eigen::Vector3d(unit(random), unit(random), unit(random)); };
  return BoxAt(0.4 * vector(), vector().cwiseAbs() + Eigen::Vector3d::Constant(0.2), 3 * vector());
}

TEST(OrientedBox, Identical) {
  const OrientedBox box = BoxAt({1, 2, 3}, {2, 3, 4}, {0.3, -0.7, 1.1});
  EXPECT_NEAR(IntersectionVolume(box, box), 24, 1e-12);
  EXPECT_NEAR(IntersectionOverUnion(box, box), 1, 1e-12);
}

// Turned by a quarter about y with its sides exchanged a box is the same set of points.
TEST(OrientedBox, TheSameByOtherAxes) {
  const OrientedBox box = BoxAt({1, 2, 3}, {2, 3, 4}, {0.3, -0.7, 1.1});
  OrientedBox turned = box;
  turned.T_world_box.rotate(Eigen::AngleAxisd(90 * kDegree, Eigen::Vector3d::UnitY()));
  turned.size = {4, 3, 2};
  EXPECT_NEAR(IntersectionOverUnion(box, turned), 1, 1e-12);
}

TEST(OrientedBox, Disjoint) {
  EXPECT_EQ(IntersectionOverUnion(BoxAt({0, 0, 0}, {1, 1, 1}), BoxAt({1.01, 0, 0}, {1, 1, 1})), 0);
  EXPECT_EQ(IntersectionVolume(BoxAt({0, 0, 0}, {1, 1, 1}), BoxAt({1, 1, 1}, {0.5, 0.5, 0.5}, {1, 2, 3})), 0);
}

TEST(OrientedBox, TouchingSidesHaveNoVolume) {
  EXPECT_NEAR(IntersectionVolume(BoxAt({0, 0, 0}, {1, 1, 1}), BoxAt({1, 0, 0}, {1, 1, 1})), 0, 1e-12);
}

TEST(OrientedBox, HalfOverlap) {
  const OrientedBox a = BoxAt({0, 0, 0}, {2, 1, 1}), b = BoxAt({1, 0, 0}, {2, 1, 1});
  EXPECT_NEAR(IntersectionVolume(a, b), 1, 1e-12);
  EXPECT_NEAR(IntersectionOverUnion(a, b), 1.0 / 3, 1e-12);
}

TEST(OrientedBox, Contained) {
  const OrientedBox outer = BoxAt({0, 0, 0}, {2, 2, 2}),
                    inner = BoxAt({0.1, 0, 0.2}, {0.5, 0.4, 0.5}, {1, 0, 2});
  EXPECT_NEAR(IntersectionVolume(outer, inner), 0.1, 1e-12);
  EXPECT_NEAR(IntersectionVolume(inner, outer), 0.1, 1e-12);
  EXPECT_NEAR(IntersectionOverUnion(outer, inner), 0.1 / 8, 1e-12);
}

// Two unit squares turned by 45 degrees have a regular octagon in common, whose area is 2 (sqrt(2) - 1).
TEST(OrientedBox, TurnedBy45Degrees) {
  const double octagon = 2 * (std::sqrt(2) - 1);
  for (int axis = 0; axis < 3; ++axis) {
    const OrientedBox turned = BoxAt({0, 0, 0}, {1, 1, 1}, 45 * kDegree * Eigen::Vector3d::Unit(axis));
    EXPECT_NEAR(IntersectionVolume(BoxAt({0, 0, 0}, {1, 1, 1}), turned), octagon, 1e-12) << axis;
  }
}

// A cube stood on its corner: the plane through its centre cuts off half, whatever the direction.
TEST(OrientedBox, HalfACubeOnItsCorner) {
  const Eigen::Matrix3d R = SmallestRotation({1, 1, 1}, {0, 1, 0});
  OrientedBox cube = BoxAt({0, 0, 0}, {1, 1, 1});
  cube.T_world_box.linear() = R;
  EXPECT_NEAR(IntersectionVolume(cube, BoxAt({0, 5, 0}, {10, 10, 10})), 0.5, 1e-12);
}

TEST(OrientedBox, WithoutVolume) {
  const OrientedBox flat = BoxAt({0, 0, 0}, {1, 0, 1}), none = BoxAt({0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(IntersectionOverUnion(flat, flat), 0);
  EXPECT_EQ(IntersectionOverUnion(none, none), 0);
  EXPECT_EQ(IntersectionOverUnion(none, BoxAt({0, 0, 0}, {1, 1, 1})), 0);
}

TEST(OrientedBox, SymmetricInItsArguments) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const OrientedBox a = RandomBox(random), b = RandomBox(random);
    EXPECT_NEAR(IntersectionVolume(a, b), IntersectionVolume(b, a), 1e-12);
  }
}

TEST(OrientedBox, AsManyRandomPointsInside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  constexpr int kPoints = 20000;
  for (int trial = 0; trial < 20; ++trial) {
    const OrientedBox a = RandomBox(random), b = RandomBox(random);
    int common = 0;
    for (int i = 0; i < kPoints; ++i) {
      const Eigen::Vector3d x(unit(random), unit(random), unit(random));
      common += Contains(b, a.T_world_box * x.cwiseProduct(a.size)) ? 1 : 0;
    }
    const double share = static_cast<double>(common) / kPoints;
    EXPECT_NEAR(IntersectionVolume(a, b) / a.volume(), share, 0.02) << "5 standard deviations";
  }
}

}  // namespace
}  // namespace armature
