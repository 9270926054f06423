// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/guard/calibration.h"
#include "bench/micro/micro_benchmarks.h"
#include "bench/micro/micro_families.h"
#include "geometry/viewpoint.h"
#include "io/category_yaml.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

MicroSetup SmallSetup() {
  MicroSetup setup;
  setup.models = LoadCategories(testing::CategoryFolder());
  setup.pose_graphs = {25};
  setup.point_sets = {100};
  return setup;
}

double TurnFromTruth(const MicroView& micro, const Eigen::Matrix3d& R) {
  return Eigen::AngleAxisd(R.transpose() * micro.truth.T_camera_object.linear()).angle();
}

TEST(MicroBenchmarks, AllRunAndTakePositiveTime) {
  const MicroSetup setup = SmallSetup();
  const std::vector<MicroBenchmark> all = MicroBenchmarks(setup);
  EXPECT_EQ(all.size(), 6 * setup.models.size() + 2);
  std::vector<Contender> contenders{CalibrationContender()};
  for (const MicroBenchmark& benchmark : all) contenders.push_back(benchmark.make());
  const std::vector<BenchRow> rows = RunInterleaved(contenders, 1, {.warm_up = 0, .repetitions = 1});
  EXPECT_EQ(rows.size(), all.size() + 1);
  const std::vector<NamedSpan> spans = MicroSpans(all, rows);
  ASSERT_EQ(spans.size(), all.size());
  for (const NamedSpan& span : spans) {
    EXPECT_GT(span.milliseconds.median, 0) << span.Key();
    EXPECT_TRUE(std::isfinite(span.milliseconds.median)) << span.Key();
  }
}

TEST(MicroBenchmarks, AreChosenByNameOrFamily) {
  const MicroSetup setup = SmallSetup();
  const auto names = [&](const std::vector<std::string>& wanted) {
    std::vector<std::string> chosen;
    for (const auto& benchmark : ChosenMicroBenchmarks(MicroBenchmarks(setup), wanted))
      chosen.push_back(benchmark.name());
    return chosen;
  };
  EXPECT_EQ(names({"neighbours", "hypothesis:chair", "neighbours:100"}),
            (std::vector<std::string>{"hypothesis:chair", "neighbours:100"}));
  EXPECT_EQ(names({}).size(), MicroBenchmarks(setup).size());
  testing::ExpectInputError([&] { names({"neighbors"}); }, {"'neighbors'", "'neighbours'"});
}

TEST(MicroBenchmarks, TabulateMicrosecondsAndDashes) {
  const std::vector<MicroBenchmark> benchmarks = {{"a", "x", "one a", {}}, {"a", "y", "one a", {}}};
  std::vector<BenchRow> rows;
  for (const double ms : {0.001, 0.002, 0.003}) {
    BenchRow row;
    row.contender = "a:x";
    row.wall_ms = ms;
    rows.push_back(row);
  }
  const std::vector<NamedSpan> spans = MicroSpans(benchmarks, rows);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0].Key(), "micro//a:x/call");
  const Table table = MicroTable(benchmarks, spans);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1].text, "3");
  EXPECT_EQ(table.rows[0][2].text, "2.00");
  EXPECT_EQ(table.rows[0][4].text, "1.00");
  EXPECT_EQ(table.rows[1][1].text, "0");
  EXPECT_EQ(table.rows[1][2].text, "");
  EXPECT_EQ(std::count(table.notes.begin(), table.notes.end(), "a: one a."), 1);
}

TEST(MicroBenchmarks, WaitWithTheTreeUntilTheRaceStarts) {
  MicroSetup setup;
  setup.point_sets = {1'000'000'000'000};  // 28 TB
  const std::vector<MicroBenchmark> all = NeighbourBenchmarks(setup);
  EXPECT_NO_THROW(all.at(0).make());
}

TEST(MicroAssociation, FindsTheTruthAmongTheHypotheses) {
  const MicroSetup setup = SmallSetup();
  for (const CategoryModel& model : setup.models) {
    const MicroView micro(model, 60);
    EXPECT_EQ(micro.view.segments.size(), 60U);
    ProjectedWireframe scratch;
    double best_cost = 1e9, best_turn = 0;
    for (const Hypothesis& hypothesis :
         MakeHypotheses(micro.view, micro.dictionary, setup.association.box, setup.association.hypotheses)) {
      const double cost = HypothesisCost(micro, hypothesis, setup.association, scratch);
      if (cost >= best_cost) continue;
      best_cost = cost;
      best_turn = TurnFromTruth(micro, hypothesis.start.T_camera_object.linear());
    }
    EXPECT_LT(best_turn, 0.2) << model.spec.name;
  }
}

TEST(MicroAssociation, MatchesTheEdgesFragments) {
  const MicroSetup setup = SmallSetup();
  for (const CategoryModel& model : setup.models) {
    const MicroView micro(model, 80);
    const Matching matching = MatchSegments(micro.Project(micro.truth), micro.view.segments,
                                            SearchGate(micro.view, setup.association));
    EXPECT_GT(matching.covered_length, 0.8 * micro.Project(micro.truth).VisibleLength()) << model.spec.name;
  }
}

TEST(MicroResection, ComesBackToTheTruth) {
  const MicroSetup setup = SmallSetup();
  const CategoryModel& chair = *std::find_if(setup.models.begin(), setup.models.end(),
                                             [](const CategoryModel& m) { return m.spec.name == "chair"; });
  const MicroView micro(chair, 60);
  const std::vector<EdgeMatch> matches = MicroMatches(micro, 14, setup.association);
  EXPECT_EQ(matches.size(), 14U);
  const PoseAndShape start = micro.NearTruth();
  for (const ResectionMode mode : {ResectionMode::kJoint, ResectionMode::kAlternating}) {
    ResectionOptions options = setup.resection;
    options.mode = mode;
    const ResectionResult result = Resect(
        {micro.view, micro.view.sides, matches, micro.Project(start), start, setup.association.box, options});
    EXPECT_TRUE(result.finite());
    EXPECT_LT(TurnFromTruth(micro, result.estimate.T_camera_object.linear()),
              0.5 * TurnFromTruth(micro, start.T_camera_object.linear()))
        << ToName(mode);
  }
}

TEST(MicroResection, EstimatesTheObjects) {
  const MicroSetup setup = SmallSetup();
  for (const CategoryModel& model : setup.models) {
    const MicroView micro(model, 60);
    const SingleViewResult result = EstimateObject(micro.view, setup.association, setup.resection);
    EXPECT_EQ(result.estimate.status, EstimateStatus::kOk) << model.spec.name;
    EXPECT_LT(TurnFromTruth(micro, result.estimate.T_camera_object.linear()), 0.1) << model.spec.name;
  }
}

TEST(MicroPoseGraph, ConvergesFromNoisyOdometry) {
  for (const size_t poses : {25U, 100U}) {
    const PoseGraph graph = NoisySphere(poses);
    EXPECT_EQ(graph.poses.size(), poses);
    const PoseGraphResult result = SolvePoseGraph(graph, {});
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.final_cost, 0.1 * PoseGraphCost(graph, graph.poses));
    // As many squared, whitened residuals as measurements beyond what the poses need.
    const double spare = 6.0 * static_cast<double>(graph.edges.size() + 1 - poses);
    EXPECT_NEAR(result.final_cost / spare, 1, 0.35);
  }
}

TEST(Calibration, AlwaysDoesTheSame) {
  CalibrationLoop loop;
  const double sum = loop.Pass();
  EXPECT_EQ(loop.Pass(), sum);
  EXPECT_NEAR(sum, 816.7217858153803, 1e-6);
}

}  // namespace
}  // namespace armature
