// SPDX-License-Identifier: BSD-3-Clause
// From rows of known durations to tables.
#include "bench/sections/bench_tables.h"

#include <gtest/gtest.h>

#include "bench/sections/comparison_section.h"
#include "bench/sections/detectors_section.h"
#include "bench/sections/objects_section.h"
#include "bench/sections/pipelined_section.h"
#include "bench/spans.h"
#include "support/bench_fakes.h"
#include "support/expect_input_error.h"
#include "support/table_cells.h"

namespace armature {
namespace {

using testing::CellText;
using testing::MakeRow;

// The other takes 3, 5 and 7 times as long; the fourth frame only we have.
std::vector<BenchRow> KnownRows() {
  std::vector<BenchRow> rows;
  for (size_t i = 0; i < 4; ++i) rows.push_back(MakeRow("ours", i, 4, 3, 2));
  rows.push_back(MakeRow("other", 0, 29, 0, 0));
  rows.push_back(MakeRow("other", 1, 49, 0, 0));
  rows.push_back(MakeRow("other", 2, 69, 0, 0));
  for (BenchRow& row : rows) {
    if (row.contender == "other") row.outcome.stages_ms = {row.outcome.stages_ms[0], {}, {}, {}};
  }
  return rows;
}

TEST(BenchTables, StagesOfEnginesBesideThePapers) {
  const Table table = StageTable(KnownRows(), {"ours", "other"}, 3);
  ASSERT_EQ(table.rows.size(), 7u);
  EXPECT_EQ(CellText(table, 0, "ours [ms]"), "4.000");
  EXPECT_EQ(CellText(table, 0, "other [ms]"), "49.000");
  EXPECT_EQ(CellText(table, 1, "other [ms]"), "");  // has no association
  EXPECT_EQ(CellText(table, 3, "stage"), "association + optimization");
  EXPECT_EQ(CellText(table, 3, "ours [ms]"), "5.000");
  EXPECT_EQ(CellText(table, 3, "paper: lines [ms]"), "360.00");
  EXPECT_EQ(CellText(table, 4, "ours [ms]"), "");  // mapping never ran
  EXPECT_EQ(CellText(table, 5, "ours [ms]"), "1.000");
  EXPECT_EQ(CellText(table, 6, "ours [ms]"), "10.000");
  EXPECT_EQ(CellText(table, 6, "paper: lines [ms]"), "360.25");
  EXPECT_EQ(CellText(table, 6, "paper: keypoints [ms]"), "855.00");
}

TEST(BenchTables, RatiosArePairedByFrame) {
  const Table table = RatioTable(CollectRatios("comparison", "", KnownRows(), {"ours", "other"}), "ours", 3);
  EXPECT_EQ(CellText(table, 0, "engine"), "other");
  EXPECT_EQ(CellText(table, 0, "n"), "3");
  EXPECT_EQ(CellText(table, 0, "times ours"), "5.00");
  EXPECT_EQ(CellText(table, 0, "p10"), "3.40");
  EXPECT_EQ(CellText(table, 1, "times ours"), "2.37");  // the paper's 855 / 360.25
}

TEST(BenchTables, SpansAreOfStagesThatRan) {
  const auto spans = CollectSpans("comparison", "s", KnownRows(), {"ours", "other"});
  ASSERT_EQ(spans.size(), 6u);  // three stages and the total of ours, one and the total of the other
  EXPECT_EQ(spans[4].Key(), "comparison/s/other/detection");
  EXPECT_EQ(spans[4].milliseconds.median, 49);
  const Table table = StatisticsTable(spans);
  EXPECT_EQ(CellText(table, 5, "stage"), "total");
  EXPECT_EQ(CellText(table, 5, "std"), "20.000");
  EXPECT_EQ(CellText(table, 5, "max"), "70.000");
}

BenchSeries MakeSeries(const std::string& name, double constant, double slope) {
  BenchSeries series{.contender = name, .x_label = "", .y_label = "", .fit = LineFit{constant, slope}};
  for (const double x : {1.0, 3.0, 20.0}) {
    series.points.push_back({x, {}});
    series.points.back().milliseconds.median = series.fit->At(x);
  }
  return series;
}

TEST(BenchTables, ObjectsHaveAConstantASlopeAndACrossover) {
  const Table table =
      ObjectFitTable({MakeSeries("ours", 5, 1), MakeSeries("net", 0, 3), MakeSeries("slow", 6, 3)});
  EXPECT_EQ(CellText(table, 0, "constant [ms]"), "5.000");
  EXPECT_EQ(CellText(table, 0, "an object [ms]"), "1.000");
  EXPECT_EQ(CellText(table, 0, "20 objects over 3"), "3.12");  // 25 / 8
  EXPECT_EQ(CellText(table, 0, "crossover with ours"), "");
  EXPECT_EQ(CellText(table, 1, "crossover with ours"), "ours is below from 2.5 objects on");
  EXPECT_EQ(CellText(table, 2, "crossover with ours"), "none: ours is below from 1 object on");
}

TEST(BenchTables, CrossoverGoesBothWays) {
  EXPECT_EQ(CrossoverText({1, 3}, {5, 1}), "ours is above from 2.0 objects on");
  EXPECT_EQ(CrossoverText({5, 1}, {4, 1}), "none: ours is above from 1 object on");
  EXPECT_EQ(CrossoverText({4, 1}, {5, 1}), "none: ours is below from 1 object on");
}

TEST(BenchTables, AnUnknownTableNamesTheNearest) {
  testing::ExpectInputError([] { CheckBenchTableName("detector"); }, {"detector", "detectors"});
}

// One true object in each frame: found with these errors, or not found.
Findings FindingsOf(double azimuth_deg, double translation_percent, int found) {
  Findings findings;
  findings.detections = 10;
  for (int i = 0; i < found; ++i) {
    ObservationError& error = findings.errors.emplace_back();
    error.azimuth_deg = azimuth_deg;
    error.translation_percent = translation_percent;
  }
  findings.recall["chair"] = {200, 50};
  return findings;
}

TEST(BenchDetectors, TheFastestIsOneThatIsAsAccurateAsLsd) {
  std::vector<DetectorChoice> choices;
  for (const DetectorChoice& choice : DetectorChoices({})) {
    const LineOptions& lines = choice.lines;
    if (!lines.boxes_only && choice.parameters == "tuned") choices.push_back(choice);
  }
  ASSERT_EQ(choices.size(), 4u);  // edgedrawing, edlines, fld, lsd
  std::vector<BenchRow> rows;
  for (size_t i = 0; i < 4; ++i)
    rows.push_back(MakeRow(choices[i].name, 0, 1 + static_cast<double>(i), 3, 1));
  const std::vector<Findings> findings{FindingsOf(2.4, 3, 10),  // too far off in azimuth
                                       FindingsOf(1, 3.2, 9),   // within 10 %
                                       FindingsOf(1, 1, 10),    // better, but slower
                                       FindingsOf(2, 3, 10)};
  EXPECT_EQ(FastestAsAccurateAsLsd(choices, rows, findings), 1);
  const Table table = DetectorTable(choices, rows, findings);
  EXPECT_EQ(CellText(table, 1, "lines [ms]"), "2.00");
  EXPECT_EQ(CellText(table, 1, "total [ms]"), "7.00");
  EXPECT_EQ(CellText(table, 1, "on top [ms]"), "5.00");
  EXPECT_EQ(CellText(table, 1, "an object [ms]"), "2.000");
  EXPECT_EQ(CellText(table, 1, "azimuth [deg]"), "1.00");
  EXPECT_EQ(CellText(table, 1, "within 15 deg [%]"), "90.0");
  EXPECT_EQ(CellText(table, 1, "recall [%]"), "25.0");
  EXPECT_EQ(CellText(RecallTable(choices, findings), 0, "chair [%]"), "25.0");
}

TEST(BenchDetectors, WithoutTruthThereAreDashes) {
  const std::vector<DetectorChoice> choices = DetectorChoices({});
  ASSERT_EQ(choices.size(), 18u);  // four detectors, tuned and published, one at half size; image and boxes
  const std::vector<Findings> nothing(choices.size());
  EXPECT_EQ(FastestAsAccurateAsLsd(choices, {}, nothing), -1);
  const Table table = DetectorTable(choices, {}, nothing);
  EXPECT_EQ(CellText(table, 0, "azimuth [deg]"), "");
  EXPECT_EQ(CellText(table, 0, "recall [%]"), "");
  EXPECT_EQ(CellText(table, 0, "lines [ms]"), "");
}

TEST(BenchTables, TwoThreadsAreComparedWithOneOfTheSameEngine) {
  const Table table = PipelinedTable({{"lines:a", false, {4, 6}, 100},
                                      {"lines:a", true, {8, 8}, 150},
                                      {"lines:b", false, {1, 1}, 500},
                                      {"lines:b", true, {1, 2}, 450}});
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(CellText(table, 0, "latency [ms]"), "5.00");
  EXPECT_EQ(CellText(table, 0, "times one thread"), "1.00");
  EXPECT_EQ(CellText(table, 1, "threads"), "2");
  EXPECT_EQ(CellText(table, 1, "latency [ms]"), "8.00");
  EXPECT_EQ(CellText(table, 1, "times one thread"), "1.50");
  EXPECT_EQ(CellText(table, 3, "frames/s"), "450.0");
  EXPECT_EQ(CellText(table, 3, "times one thread"), "0.90");
}

}  // namespace
}  // namespace armature
