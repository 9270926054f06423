// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "category/normalise.h"
#include "datasets/cad/chair.h"
#include "datasets/cad/laptop.h"
#include "datasets/cad/table.h"
#include "geometry/random.h"

namespace armature {
namespace {

TEST(Random, IsTheSameOnEveryPlatform) {
  Random random(1);
  EXPECT_EQ(random.Uniform(0, 1), 0.13387664401253263);
  Random again(1);
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += again.Uniform(0, 1);
  Random normal(1);
  EXPECT_EQ(normal.Normal(2, 3), 2 + 3 * sum);
}

TEST(Random, NormalHasItsMeanAndDeviation) {
  Random random(5);
  double sum = 0, squares = 0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double x = random.Normal(1, 2);
    sum += x;
    squares += (x - 1) * (x - 1);
  }
  EXPECT_NEAR(sum / count, 1, 0.05);
  EXPECT_NEAR(squares / count, 4, 0.15);
}

TEST(Families, SameSeedSameMembers) {
  const auto a = SampleTableFamily(50, 7), b = SampleTableFamily(50, 7), c = SampleTableFamily(50, 8);
  EXPECT_EQ(a[49].width, b[49].width);
  EXPECT_NE(a[49].width, c[49].width);
  EXPECT_EQ(SampleLaptopFamily(50, 7)[49].depth, SampleLaptopFamily(50, 7)[49].depth);
}

TEST(Families, TablesStayWithinFurnitureSizes) {
  for (const TableParameters& table : SampleTableFamily(2000, 3)) {
    EXPECT_GE(table.width, table.depth);
    EXPECT_GE(table.depth, 0.45);
    EXPECT_LE(table.width, 2.30);
    EXPECT_GE(table.height, 0.70);
    EXPECT_LE(table.height, 0.78);
    EXPECT_LT(2 * table.overhang_x, 0.5 * table.width);
    EXPECT_LT(2 * table.overhang_z, 0.8 * table.depth);
    EXPECT_LT(table.leg_start, 0.2);
  }
}

TEST(Families, ChairsStayWithinFurnitureSizes) {
  for (const ChairParameters& chair : SampleChairFamily(2000, 3)) {
    const Eigen::Vector3d size = BoundingBoxSize(ChairWireframe(chair));
    EXPECT_GT(size.minCoeff(), 0.36);
    EXPECT_LT(size.maxCoeff(), 1.18);
    EXPECT_NEAR(chair.seat_height, 0.45, 0.036);
    EXPECT_GT(chair.height - chair.seat_height, 0.15);
    EXPECT_LT(chair.cushion + chair.seat_thickness, 0.1);
    EXPECT_GE(chair.bars, 2);
  }
}

TEST(Families, ChairEdgesAreWhereTheirParametersSay) {
  ChairParameters parameters;
  parameters.recline = 0.1;
  parameters.seat_rise = 0.02;
  parameters.front_feet = 0.50;
  const Wireframe chair = ChairWireframe(parameters);
  EXPECT_LT((chair.End(0, 0) - Eigen::Vector3d(-0.22, 0.89, -0.1)).norm(), 1e-12);   // back_top, at the left
  EXPECT_LT((chair.End(5, 1) - Eigen::Vector3d(-0.225, 0.47, 0.41)).norm(), 1e-12);  // seat_left, in front
  EXPECT_LT((chair.End(7, 1) - Eigen::Vector3d(-0.25, 0, 0.40)).norm(), 1e-12);  // leg_front_left, its foot
  EXPECT_LT((chair.End(9, 0) - chair.End(2, 1)).norm(), 1e-12);  // the right post goes on as the rear leg
}

TEST(Families, TableEdgesAreWhereTheirParametersSay) {
  TableParameters parameters;
  parameters.width = 1.6;
  parameters.overhang_x = 0.10;
  parameters.overhang_z = 0.05;
  parameters.leg_start = 0.06;
  parameters.splay = 0.02;
  const Wireframe table = TableWireframe(parameters);
  EXPECT_EQ(BoundingBoxSize(table).x(), 1.6);
  EXPECT_NEAR(BoundingBoxSize(table).y(), 0.74, 1e-15);
  // top_rear starts at the left, leg_front_right under the top, its foot is splayed.
  EXPECT_LT((table.End(0, 0) - Eigen::Vector3d(-0.8, 0.74, -0.4)).norm(), 1e-12);
  EXPECT_LT((table.End(6, 0) - Eigen::Vector3d(0.7, 0.68, 0.35)).norm(), 1e-12);
  EXPECT_LT((table.End(6, 1) - Eigen::Vector3d(0.72, 0, 0.37)).norm(), 1e-12);
}

TEST(Families, LaptopLidIsOpenByItsAngle) {
  LaptopParameters parameters;
  parameters.lid_height = 0.20;
  parameters.lid_angle_deg = 120;
  const Wireframe laptop = LaptopWireframe(parameters);
  const Eigen::Vector3d lid = -laptop.directions.col(1), base = laptop.directions.col(4);
  EXPECT_NEAR(lid.norm(), 0.20, 1e-12);
  EXPECT_NEAR(lid.normalized().dot(base.normalized()), -0.5, 1e-12);
  EXPECT_GT(lid.y(), 0);
  EXPECT_NEAR(BoundingBoxSize(laptop).z(), 0.24 + 0.10, 1e-12);
}

}  // namespace
}  // namespace armature
