// SPDX-License-Identifier: BSD-3-Clause
// A run with a known error beside one without.
#include <gtest/gtest.h>

#include "eval/statistics/result_distance.h"
#include "eval/statistics/run_values.h"
#include "io/provenance.h"
#include "support/expect_input_error.h"
#include "support/true_map.h"

namespace armature {
namespace {

using testing::TrueMap;
using testing::TrueWorld;
using testing::WriteMap;

// The map and the single views of chairs lie 0.3 m to the side.
std::filesystem::path RunWithChairAside(const TrueWorld& world, const std::string& name, double aside) {
  std::vector<PlacedObject> map = TrueMap(world.sequence.truth);
  map.at(0).T_world_object.translation().x() += aside;
  WriteMap(world, name, map, {});
  const auto move = [aside](const std::string& category, const Eigen::Isometry3d& truth) {
    return category == "chair" ? Eigen::Translation3d(aside, 0, 0) * truth : truth;
  };
  return world.WriteRun(name, move, testing::SameName);
}

const NamedValues& ValuesNamed(const std::vector<NamedValues>& all, const std::string& name) {
  for (const NamedValues& values : all) {
    if (values.name == name) return values;
  }
  throw std::logic_error("no " + name);
}

TEST(RunValues, AreTheErrorsOfObjectsViewsAndCameras) {
  const TrueWorld world;
  const auto errors =
      ComputeRunErrors(RunWithChairAside(world, "b", 0.3), world.folder / "sequence", world.models, {});
  const auto& centres = ValuesNamed(errors, "object centre error [m]").values;
  EXPECT_NEAR(centres.at({"chair0"}), 0.3, 1e-9);
  EXPECT_NEAR(centres.at({"table0"}), 0, 1e-9);
  const auto& views = ValuesNamed(errors, "single view translation error [%]").values;
  ASSERT_EQ(views.size(), 4u);
  EXPECT_NEAR(views.at({"chair0", 0, 0}), 100 * 0.3 / std::hypot(0.7, 3), 1e-6);
  EXPECT_NEAR(views.at({"table0", 200'000, 1}), 0, 1e-6);
  EXPECT_EQ(ValuesNamed(errors, "camera position error [m]").values.size(), 2u);
}

TEST(RunValues, WithoutTruthAreNone) {
  const TrueWorld world;
  EXPECT_TRUE(
      ComputeRunErrors(RunWithChairAside(world, "b", 0), world.folder / "gone", world.models, {}).empty());
}

TEST(RunValues, OfTimesAreOneAFrameAndStage) {
  const TrueWorld world;
  const std::string run = RunWithChairAside(world, "b", 0).string();
  world.folder.Write("b/timings.csv", "timestamp,lines_ms,total_ms\n0.0,1,2\n0.2,3,4\n");
  const auto times = ReadRunTimes(run);
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(ValuesNamed(times, "time: total [ms]").values.at({"", 200'000}), 4);
  world.folder.Write("b/timings.csv", "timestamp,lines_ms\n0.0,fast\n");
  testing::ExpectInputError([&] { ReadRunTimes(run); }, {"timings.csv:2", "fast"});
}

TEST(RunValues, OfLoadingTellABusyMachine) {
  const auto remark = [](double ratio) {
    ComparedValues load{"time: load [ms]", 3, {}, 0, 0};
    for (int i = 0; i < 8; ++i) load.pairs.push_back({{"", i}, {"", 3, 3 * ratio}});
    return PaceRemark({load});
  };
  EXPECT_FALSE(remark(1.1));
  ASSERT_TRUE(remark(2));
  EXPECT_NE(remark(2)->find("2.00 times as long in B"), std::string::npos);
  EXPECT_TRUE(remark(0.5));
}

TEST(ResultDistance, IsThatOfTheSecondFromTheFirst) {
  const TrueWorld world;
  const auto a = RunWithChairAside(world, "a", 0.1), b = RunWithChairAside(world, "b", 0.4);
  const auto distances = ResultDistances(a, b, world.specs, {});
  ASSERT_EQ(distances.size(), 3u);
  ASSERT_EQ(distances[0].pairs.size(), 2u);
  EXPECT_EQ(distances[0].pairs[0].first.series, "map_chair0");
  EXPECT_NEAR(distances[0].pairs[0].second.b, 0.3, 1e-9);
  EXPECT_NEAR(distances[0].pairs[1].second.b, 0, 1e-9);
  EXPECT_EQ(distances[2].pairs.size(), 2u);
  EXPECT_EQ(DistanceTable(distances).rows[0][3].text, "0.3000");
}

TEST(ResultDistance, CountsObjectsWithoutCounterpart) {
  const TrueWorld world;
  const auto a = RunWithChairAside(world, "a", 0), b = RunWithChairAside(world, "b", 5);
  const auto distances = ResultDistances(a, b, world.specs, {});
  EXPECT_EQ(distances[0].pairs.size(), 1u);
  EXPECT_EQ(distances[0].only_a, 1u);
  EXPECT_EQ(distances[0].only_b, 1u);
}

std::vector<ProvenanceRemark> RemarksBetween(const TrueWorld& world, const std::string& b_summary) {
  const std::string summary =
      R"({"sequence": "world", "complete": true, "threads": 1, "git": {"commit": "abc"},
      "machine": {"cpu": "X"}, "counts": {"detections": 5}})";
  world.folder.Write("a/summary.json", summary);
  world.folder.Write("b/summary.json", b_summary.empty() ? summary : b_summary);
  return CompareRunProvenance(IdentifyRun(world.folder / "a"), IdentifyRun(world.folder / "b"));
}

TEST(Provenance, OfTheSameIsWithoutRemark) { EXPECT_TRUE(RemarksBetween(TrueWorld(), "").empty()); }

TEST(Provenance, WarnsOfAnotherMachineAndTellsTheCommit) {
  const auto remarks = RemarksBetween(TrueWorld(), R"({"sequence": "world", "complete": true, "threads": 1,
      "git": {"commit": "def", "dirty": true}, "machine": {"cpu": "Y"}, "counts": {"detections": 5}})");
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].text, "CPU: X in A, Y in B: times do not compare");
  EXPECT_TRUE(remarks[0].is_warning);
  EXPECT_EQ(remarks[1].text, "commit: abc in A, def (modified) in B");
  EXPECT_FALSE(remarks[1].is_warning);
}

TEST(Provenance, TellsOptionsThatDiffer) {
  const TrueWorld world;
  world.folder.Write("a/config.yaml", "mapping:\n  loop_closure: true\n  gate: 2\n");
  world.folder.Write("b/config.yaml", "mapping:\n  loop_closure: false\n  gate: 2\n");
  const auto remarks = RemarksBetween(world, "");
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].text, "Options that differ (A, B): mapping.loop_closure (true, false).");
}

}  // namespace
}  // namespace armature
