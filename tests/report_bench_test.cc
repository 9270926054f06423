// SPDX-License-Identifier: BSD-3-Clause
// What a report takes from a benchmark.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/bench_json.h"
#include "eval/report/bench_results.h"
#include "eval/report/headline.h"
#include "support/expect_input_error.h"
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

  BenchResults Read() const {
    folder_.Write("bench.json", json_.dump());
    return ReadBenchResults(folder_.path());
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
  EXPECT_EQ(all[0].stages, (std::vector<std::string>{"detection", "mapping", "optimization"}));
  ASSERT_EQ(all[0].bars.size(), 2u);
  EXPECT_EQ(all[0].bars[0].milliseconds, (std::vector<double>{4, 2, 0}));
  EXPECT_EQ(all[0].bars[1].milliseconds, (std::vector<double>{440, 0, 10}));
}

TEST_F(ReportBench, CurvesOverTheSameAxesShareAPlot) {
  const BenchResults bench = Read();
  ASSERT_EQ(bench.curves.size(), 1u);
  EXPECT_EQ(bench.curves[0].x_label, "objects");
  ASSERT_EQ(bench.curves[0].curves.size(), 2u);
  EXPECT_EQ(bench.curves[0].curves[1].points[1].x, 20);
  EXPECT_EQ(bench.curves[0].curves[1].points[1].median, 9);
  EXPECT_EQ(bench.environment[0].first, "benchmark: machine");
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
  testing::ExpectInputError([&] { ReadBenchResults(folder_ / "none"); }, {"none/bench.json"});
  json_["series"][0].erase("points");
  ExpectRefusedBench({"bench.json", "is malformed", "points", "armature bench"});
  json_["complete"] = false;
  ExpectRefusedBench({"bench.json", "is not a finished benchmark", "armature bench"});
  folder_.Write("bench.json", "{");
  testing::ExpectInputError([&] { ReadBenchResults(folder_.path()); }, {"bench.json", "is not JSON"});
}

}  // namespace
}  // namespace armature
