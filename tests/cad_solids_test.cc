// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "datasets/cad/solids.h"
#include "support/part_volume.h"

namespace armature {
namespace {

using Eigen::Vector3d;
using testing::IsClosed;
using testing::Volume;

// Area of a regular polygon of this many corners on a circle.
double PolygonArea(int sides, double radius) {
  return 0.5 * sides * radius * radius * std::sin(2 * std::numbers::pi / sides);
}

TEST(Solids, BlockHasItsVolumeAndGrainAlongItsLongestSide) {
  const Part block = Block(Vector3d(0, 0, 0), Vector3d(0.1, 0.7, 0.2), {});
  EXPECT_TRUE(IsClosed(block));
  EXPECT_NEAR(Volume(block), 0.014, 1e-12);
  EXPECT_NEAR(std::abs(block.T_mesh_part.linear().col(0).y()), 1, 1e-12);
}

TEST(Solids, BeamsAreSolidAlongEveryAxisAndInBothDirections) {
  for (const int axis : {0, 1, 2}) {
    for (const double sense : {-1.0, 1.0}) {
      const Vector3d to = sense * 0.5 * Vector3d::Unit(axis) + Vector3d::Constant(0.1);
      const Part beam = Beam(Vector3d::Constant(0.1), to, axis, {0.04, 0.02}, {0.04, 0.02}, {});
      EXPECT_TRUE(IsClosed(beam));
      EXPECT_NEAR(Volume(beam), 0.5 * 0.04 * 0.02, 1e-12) << axis << " " << sense;
    }
  }
}

TEST(Solids, InclinedPoleStandsFlatOnTheFloor) {
  const Part pole = Pole({0, 0, 0}, {0.1, 0.4, -0.1}, 0.02, 0.02, 10, {});
  EXPECT_TRUE(IsClosed(pole));
  EXPECT_NEAR(Volume(pole), 0.4 * PolygonArea(10, 0.02), 1e-12);  // Cavalieri
  const Eigen::AlignedBox3d box = BoundingBox(Mesh{{pole}});
  EXPECT_EQ(box.min().y(), 0);
  EXPECT_EQ(box.max().y(), 0.4);
}

TEST(Solids, SlabIsSolidBetweenItsOutlines) {
  const Part slab = Slab({Vector3d(0, 0, 0), {0, 0, 1}, {2, 0, 1}, {2, 0, 0}},
                         {Vector3d(0, 3, 0), {0, 3, 1}, {2, 3, 1}, {2, 3, 0}}, {});
  EXPECT_TRUE(IsClosed(slab));
  EXPECT_NEAR(Volume(slab), 6, 1e-12);
}

TEST(Solids, CylinderIsSolid) {
  const Part cylinder = Cylinder({0, 0, 0}, {0.3, 0, 0}, 0.1, 0.1, 8, {});
  EXPECT_TRUE(IsClosed(cylinder));
  EXPECT_NEAR(Volume(cylinder), 0.3 * PolygonArea(8, 0.1), 1e-12);
}

}  // namespace
}  // namespace armature
