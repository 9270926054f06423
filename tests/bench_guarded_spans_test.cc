// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/guard/guarded_spans.h"
#include "bench/spans.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

NamedSpan SpanNamed(const std::string& table, const std::string& sequence, const std::string& contender,
                    const std::string& stage, double median = 1) {
  NamedSpan span{table, sequence, contender, stage, {}};
  span.milliseconds.median = median;
  return span;
}

BenchReport TwoSections() {
  BenchReport report;
  report.sections = {{.name = "comparison", .sequence = "a"}, {.name = "micro", .sequence = ""}};
  report.sections[0].spans = {SpanNamed("comparison", "a", "lines:default", "detection"),
                              SpanNamed("comparison", "a", "lines:default", "mapping", 0)};
  report.sections[0].calibration_ms = {1, 2};
  report.sections[1].spans = {SpanNamed("micro", "", "matching:chair", "call")};
  report.sections[1].calibration_ms = {6};
  return report;
}

TEST(GuardedSpans, OneCalibrationIsOfAllSections) {
  const BenchRecord record = MakeRecord({}, TwoSections());
  EXPECT_EQ(record.calibration.n, 3u);
  EXPECT_EQ(record.calibration.mean, 3);
  ASSERT_EQ(record.spans.size(), 4u);  // nothing was done in mapping
  EXPECT_EQ(record.spans[1].Key(), "comparison/a/calibration/pass");
  EXPECT_EQ(record.spans[1].milliseconds.median, 1.5);
  EXPECT_EQ(record.spans[2].Key(), "micro//matching:chair/call");
}

TEST(GuardedSpans, ANetworkThatOnlyTakesTimeIsNoWork) {
  const auto is_work = [](const std::string& contender, std::string_view stage) {
    return IsMachinesWork(SpanNamed("comparison", "a", contender, std::string(stage)));
  };
  EXPECT_FALSE(is_work("keypoints:published", "detection"));
  EXPECT_FALSE(is_work("keypoints:wait with 3 objects", kTotal));
  EXPECT_TRUE(is_work("keypoints:published", "optimization"));
  EXPECT_TRUE(is_work("keypoints:hourglass", "detection"));
  EXPECT_TRUE(is_work("lines:default", kTotal));
}

TEST(GuardedSpans, OnlyTablesThatAreMeasuredAreCompared) {
  BenchRecord record = MakeRecord({}, TwoSections());
  record.spans.push_back(SpanNamed("comparison", "b", "lines:default", "total"));
  const BenchRecord part = GuardedPart(record, {{"comparison", "a"}, {"objects", "b"}});
  ASSERT_EQ(part.spans.size(), 2u);
  EXPECT_EQ(part.spans[0].Key(), "comparison/a/lines:default/detection");
  EXPECT_EQ(part.spans[1].Key(), "comparison/a/calibration/pass");
  EXPECT_EQ(part.calibration.n, 3u);
}

TEST(GuardedSpans, NothingInCommonIsAnError) {
  const BenchRecord record = MakeRecord({}, TwoSections());
  EXPECT_NO_THROW(CheckSharesTables(record, {{"micro", ""}}));
  testing::ExpectInputError(
      [&] {
        CheckSharesTables(record, {{"comparison", "b"}});
      },
      {"--against", "comparison of a, micro"});
}

}  // namespace
}  // namespace armature
