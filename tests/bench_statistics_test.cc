// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics.h"

namespace armature {
namespace {

TEST(SpanStatistics, OfNothingIsNothing) { EXPECT_FALSE(ComputeStatistics({})); }

TEST(SpanStatistics, OfOneValueIsThatValueWithoutDeviation) {
  const SpanStatistics s = ComputeStatistics({4}).value();
  EXPECT_EQ(s.n, 1U);
  EXPECT_EQ(s.mean, 4);
  EXPECT_EQ(s.deviation, 0);
  EXPECT_EQ(s.median, 4);
  EXPECT_EQ(s.p10, 4);
  EXPECT_EQ(s.p99, 4);
  EXPECT_EQ(s.max, 4);
}

TEST(SpanStatistics, AreThoseOfNumpy) {
  // numpy: mean 5.5, std(ddof=1) 3.0277, percentiles 10, 50, 90, 99 of 1..10: 1.9, 5.5, 9.1, 9.91.
  const SpanStatistics s = ComputeStatistics({10, 1, 9, 2, 8, 3, 7, 4, 6, 5}).value();
  EXPECT_EQ(s.n, 10U);
  EXPECT_DOUBLE_EQ(s.mean, 5.5);
  EXPECT_NEAR(s.deviation, 3.0276503540974917, 1e-12);
  EXPECT_DOUBLE_EQ(s.median, 5.5);
  EXPECT_DOUBLE_EQ(s.p10, 1.9);
  EXPECT_DOUBLE_EQ(s.p90, 9.1);
  EXPECT_DOUBLE_EQ(s.p99, 9.91);
  EXPECT_EQ(s.max, 10);
}

TEST(SpanStatistics, SayWhereTheMedianMayLie) {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i);
  const SpanStatistics many = ComputeStatistics(values).value();
  EXPECT_DOUBLE_EQ(many.median_low, 35.65);  // numpy: the quantiles 0.5 -+ 1.5 / sqrt(100)
  EXPECT_DOUBLE_EQ(many.median_high, 65.35);
  const SpanStatistics few = ComputeStatistics({3, 1, 7, 2, 5}).value();
  EXPECT_EQ(few.median_low, 1);
  EXPECT_EQ(few.median_high, 7);
}

TEST(SpanStatistics, SpreadIsHalfOfP10ToP90OverTheMedian) {
  EXPECT_DOUBLE_EQ(ComputeStatistics({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}).value().spread(), 3.6 / 5.5);
}

}  // namespace
}  // namespace armature
