// SPDX-License-Identifier: BSD-3-Clause
// What a report takes from a benchmark.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/bench_json.h"
#include "eval/report/headline.h"
#include "eval/report/report_plots.h"
#include "eval/report/reported_bench.h"
#include "support/expect_input_error.h"
#include "support/path_override.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

SpanStatistics Milliseconds(double value) { return ComputeStatistics({value}).value(); }

// Two engines on seq1, the lines 6 ms, the network 450 ms; a curve each.
BenchReport TwoEngines() {
  BenchSection section{.name = "comparison", .sequence = "seq1"};
  const auto span = [&](const char* engine, const char* stage, double ms) {
    section.spans.push_back({"comparison", "seq1", engine, stage, Milliseconds(ms)});
  };
  span("lines:default", "detection", 4);
  span("lines:default", "mapping", 2);
  span("lines:default", "total", 6);
  span("keypoints:hourglass", "detection", 440);
  span("keypoints:hourglass", "optimization", 10);
  span("keypoints:hourglass", "total", 450);
  section.ratios = {
      {"comparison", "seq1", "keypoints:hourglass", "lines:default", ComputeStatistics({74.5}).value()}};
  for (const char* engine : {"lines:default", "keypoints:hourglass"}) {
    BenchSeries series{.contender = engine, .x_label = "objects", .y_label = "total [ms]"};
    series.points = {{1, Milliseconds(3)}, {20, Milliseconds(9)}};
    section.series.push_back(series);
  }
  section.calibration_ms = {1.5};
  return {{section}};
}

class ReportBench : public ::testing::Test {
 protected:
  ReportBench() : json_(Json::parse(BenchJson(GetBenchEnvironment(1), Json{{"objects", 3}}, TwoEngines()))) {}

  ReportedBench Read() const {
    folder_.Write("bench.json", json_.dump());
    return ReadReportedBench(folder_.path());
  }
  void ExpectRefusedBench(const std::vector<std::string>& texts) const {
    testing::ExpectInputError([&] { Read(); }, texts);
  }

  testing::TempFolder folder_;
  Json json_;
};

TEST_F(ReportBench, TimesBesideThePapers) {
  const auto figures = TimingFigures(Read());
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].ours, "6.00 ms");
  EXPECT_EQ(figures[0].paper, "360.25 ms");
  EXPECT_EQ(figures[1].ours, "74.5 times");  // of pairs; not 450 / 6
  EXPECT_EQ(figures[1].paper, "2.37 times");
  EXPECT_EQ(figures[2].ours, "450.00 ms");
  EXPECT_EQ(figures[2].paper, "855.00 ms");
}

TEST_F(ReportBench, StagesAreStackedWithoutTheTotal) {
  const auto all = MakeStageBars(Read());
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].sequence, "seq1");
  const StackedBars& bars = all[0].bars;
  EXPECT_EQ(bars.stages, (std::vector<std::string>{"detection", "mapping", "optimization"}));
  ASSERT_EQ(bars.bars.size(), 2u);
  EXPECT_EQ(bars.bars[0].parts, (std::vector<double>{4, 2, 0}));
  EXPECT_EQ(bars.bars[1].parts, (std::vector<double>{440, 0, 10}));
}

TEST_F(ReportBench, CurvesOverTheSameAxesShareAPlot) {
  const ReportedBench bench = Read();
  ASSERT_EQ(bench.curves.size(), 1u);
  const Plot& plot = bench.curves[0].plot;
  EXPECT_EQ(plot.x_label, "objects");
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[1].x[1], 20);
  EXPECT_EQ(plot.series[1].y[1], 9);
  EXPECT_FALSE(plot.log_x || plot.log_y);
  EXPECT_EQ(bench.environment[0].first, "benchmark: machine");
}

TEST_F(ReportBench, AxesAreLogarithmicWhereSmallValuesCouldNotBeRead) {
  json_["series"][0]["points"][0]["x"] = 0.1;
  json_["series"][0]["points"][0]["median"] = 0.1;
  const Plot plot = Read().curves[0].plot;
  EXPECT_TRUE(plot.log_x && plot.log_y);
  json_["series"][0]["points"][0]["x"] = 0;
  json_["series"][0]["points"][0]["median"] = 0;
  const Plot with_zero = Read().curves[0].plot;
  EXPECT_FALSE(with_zero.log_x || with_zero.log_y);
}

void ExpectTextsInPicture(const ReportPlot& plot, const std::vector<std::string>& texts) {
  EXPECT_EQ(plot.picture.mime, "image/svg+xml");
  for (const std::string& text : texts) EXPECT_NE(plot.picture.bytes.find(text), std::string::npos) << text;
}

TEST_F(ReportBench, PlotsNameWhatTheyShow) {
  const ReportedBench bench = Read();
  std::vector<std::string> remarks;
  const auto bars = DrawStageBars(MakeStageBars(bench), bench.objects, remarks);
  const auto curves = DrawTimeCurves(bench.curves, remarks);
  const auto ablations = DrawAblationBars({{"seq1", "Pitch", "deg", {{"none", 2.38}, {"all", 1}}}}, remarks);
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_EQ(bars[0].caption, "Median time of each stage, frames of seq1 with 3 objects");
  ExpectTextsInPicture(bars[0], {">detection<", ">mapping<", ">lines:default<", ">6.0 ms<", ">450.0 ms<"});
  ASSERT_EQ(curves.size(), 1u);
  ExpectTextsInPicture(curves[0], {">objects<", ">total [ms]<", ">lines:default<", ">keypoints:hourglass<"});
  EXPECT_EQ(curves[0].picture.alt, "total [ms] against objects: lines:default, keypoints:hourglass");
  ASSERT_EQ(ablations.size(), 1u);
  ExpectTextsInPicture(ablations[0], {">none<", ">2.38 deg<"});
  EXPECT_TRUE(remarks.empty());
}

TEST_F(ReportBench, NothingToShowIsNoPlot) {
  std::vector<std::string> remarks;
  EXPECT_TRUE(DrawStageBars({{"seq1", {}}}, 3, remarks).empty());
  EXPECT_TRUE(DrawTimeCurves({{"seq1", {}}}, remarks).empty());
  EXPECT_TRUE(DrawAblationBars({{"seq1", "Pitch", "deg", {{"none", 0}}}}, remarks).empty());
  EXPECT_TRUE(remarks.empty());
}

TEST_F(ReportBench, WithoutGnuplotARemarkStandsForThePlots) {
  const ReportedBench bench = Read();
  std::vector<std::string> remarks;
  const testing::PathOverride nowhere(folder_.path());
  EXPECT_TRUE(DrawTimeCurves(bench.curves, remarks).empty());
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_TRUE(remarks[0].starts_with("The plots are left out: cannot start gnuplot")) << remarks[0];
}

TEST_F(ReportBench, AMissingKeyIsNamed) {
  const Json whole = json_;
  json_["ratios"][0].erase("reference");
  ExpectRefusedBench({"bench.json", "'reference'"});
  json_ = whole;
  json_["settings"].erase("objects");
  ExpectRefusedBench({"bench.json", "'objects'"});
}

TEST_F(ReportBench, BadFilesAreRefused) {
  testing::ExpectInputError([&] { ReadReportedBench(folder_ / "none"); }, {"none/bench.json"});
  json_["series"][0].erase("points");
  ExpectRefusedBench({"bench.json", "has to be", "points", "armature bench"});
  json_["complete"] = false;
  ExpectRefusedBench({"bench.json", "is not a finished benchmark", "armature bench"});
  folder_.Write("bench.json", "{");
  testing::ExpectInputError([&] { ReadReportedBench(folder_.path()); }, {"bench.json", "is not JSON"});
}

}  // namespace
}  // namespace armature
