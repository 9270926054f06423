// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/sections/line_fit.h"

namespace armature {
namespace {

TEST(LineFit, FindsTheLineDespitePointsThatAreFarOff) {
  std::vector<FitPoint> points;
  for (int x = 1; x <= 12; ++x) points.push_back({static_cast<double>(x), 5 + 1.5 * x});
  points[3].y = 400;
  points[8].y = -50;
  points[11].y = 90;
  const auto fit = FitLine(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 1.5, 0.02);
  EXPECT_NEAR(fit->constant, 5, 0.2);
}

TEST(LineFit, NeedsTwoDifferentPositions) {
  EXPECT_FALSE(FitLine({}));
  EXPECT_FALSE(FitLine({{2, 1}, {2, 3}}));
  const auto fit = FitLine({{1, 3}, {2, 5}});
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->slope, 2);
  EXPECT_EQ(fit->constant, 1);
}

TEST(LineFit, LinesCrossOnce) {
  EXPECT_EQ(Crossing({5, 1}, {0, 3}), 2.5);
  EXPECT_EQ(Crossing({5, 1}, {0, 1}), std::nullopt);
}

}  // namespace
}  // namespace armature
