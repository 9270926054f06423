// SPDX-License-Identifier: BSD-3-Clause
// Runs with known errors against a known truth.
#include <gtest/gtest.h>

#include "eval/views/evaluation_tables.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::HalfTurn;
using testing::SameName;
using testing::TrueWorld;
using testing::Unchanged;

const char* const kObservationsHeader =
    "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n";
const char* const kAssociationsHeader =
    "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n";

MatchCounts Sum(const RunEvaluation& evaluation, const std::string& category) {
  MatchCounts sum;
  for (const EvaluatedDetection& d : evaluation.detections) {
    if (d.category != category) continue;
    sum.matches += d.matches->matches;
    sum.visible_edges += d.matches->visible_edges;
    sum.on_edge.matches += d.matches->on_edge.matches;
    sum.on_edge.edges += d.matches->on_edge.edges;
  }
  return sum;
}

TEST(EvalRun, TruthAsResultIsPerfect) {
  const TrueWorld world;
  const RunEvaluation evaluation = world.Evaluate(world.WriteRun("run", Unchanged, SameName));
  ASSERT_EQ(evaluation.detections.size(), 4u);
  EXPECT_EQ(evaluation.without_truth, 0);
  for (const EvaluatedDetection& d : evaluation.detections) {
    ASSERT_TRUE(d.error && d.matches) << d.object;
    EXPECT_NEAR(d.error->azimuth_deg, 0, 1e-6);
    EXPECT_NEAR(d.error->translation_percent, 0, 1e-6);
    EXPECT_NEAR(d.error->elevation_axis_deg, 0, 1e-4);
    EXPECT_GE(d.matches->visible_edges, 7);
    EXPECT_EQ(d.matches->matches, d.matches->visible_edges);
    EXPECT_EQ(d.matches->on_edge.matches, d.matches->matches);
    EXPECT_EQ(d.matches->on_edge.edges, d.matches->visible_edges);
  }
}

TEST(EvalRun, HalfATurnIsWrongForAChairAndNothingForATable) {
  const TrueWorld world;
  const RunEvaluation evaluation = world.Evaluate(world.WriteRun("run", HalfTurn, SameName));
  for (const EvaluatedDetection& d : evaluation.detections) {
    EXPECT_NEAR(d.error->azimuth_deg, d.category == "chair" ? 180 : 0, 1e-6);
    EXPECT_NEAR(d.error->translation_percent, 0, 1e-6);
  }
}

// An estimate that is turned by 180 degrees calls the table's rear edge its front edge.
TEST(EvalRun, EdgesOfATurnedTableHaveTheirCounterpartsNames) {
  const TrueWorld world;
  const auto counterpart = [](const std::string& category, std::string edge) {
    if (category != "table") return edge;
    const std::vector<std::pair<std::string, std::string>> swaps = {{"rear", "front"}, {"left", "right"}};
    for (const auto& [a, b] : swaps) {
      if (const size_t at = edge.find(a); at != std::string::npos) {
        edge.replace(at, a.size(), b);
      } else if (const size_t other = edge.find(b); other != std::string::npos) {
        edge.replace(other, b.size(), a);
      }
    }
    return edge;
  };
  const auto turn_table = [](const std::string& category, const Eigen::Isometry3d& truth) {
    return category == "table" ? HalfTurn(category, truth) : truth;
  };
  const MatchCounts named = Sum(world.Evaluate(world.WriteRun("named", turn_table, counterpart)), "table");
  EXPECT_EQ(named.on_edge.matches, named.matches);
  EXPECT_EQ(named.on_edge.edges, named.visible_edges);
  const MatchCounts unnamed = Sum(world.Evaluate(world.WriteRun("unnamed", turn_table, SameName)), "table");
  EXPECT_EQ(unnamed.on_edge.matches, 0);
}

TEST(EvalRun, KnownErrors) {
  const TrueWorld world;
  const auto change = [](const std::string&, const Eigen::Isometry3d& truth) {
    Eigen::Isometry3d changed = truth;
    changed.translation() *= 1.1;  // along the ray: the azimuth is seen along it and stays
    return changed * Eigen::AngleAxisd(20 * kDegree, Eigen::Vector3d::UnitY());
  };
  for (const EvaluatedDetection& d : world.Evaluate(world.WriteRun("run", change, SameName)).detections) {
    EXPECT_NEAR(d.error->azimuth_deg, 20, 1e-6);
    EXPECT_NEAR(d.error->translation_percent, 10, 1e-6);
    EXPECT_NEAR(d.error->distance_percent, 10, 1e-6);
    EXPECT_NEAR(d.error->elevation_axis_deg, 0, 1e-4);
  }
}

TEST(EvalRun, WrongNamesAreWrongMatches) {
  const TrueWorld world;
  const auto rename = [](const std::string&, const std::string& edge) {
    return edge == "leg_front_left" ? "leg_rear_right" : edge;
  };
  const MatchCounts counts = Sum(world.Evaluate(world.WriteRun("run", Unchanged, rename)), "chair");
  EXPECT_EQ(counts.on_edge.matches, counts.matches - 2);  // one a frame
  EXPECT_EQ(counts.on_edge.edges, counts.visible_edges - 2);
}

TEST(EvalRun, WithoutCadMatchesAreNotJudged) {
  const TrueWorld world;
  const RunResults run = LoadRun(world.WriteRun("run", Unchanged, SameName));
  const RunEvaluation evaluation = EvaluateRun(run, world.sequence, world.models, CadLibrary());
  for (const EvaluatedDetection& d : evaluation.detections) EXPECT_FALSE(d.matches);
}

TEST(EvalRun, MissingAndFalseDetectionsAreCounted) {
  const TrueWorld world;
  const std::string rows =
      "0.0,0,ok,,1,5,-0.7,0,3,0,0,0,1,\n"  // the chair
      "0.0,1,too_few_edges,,,0,,,,,,,,\n"  // the table, without pose
      "0.2,2,ok,,1,5,0,0,3,0,0,0,1,\n"     // a false alarm
      "0.3,0,ok,,1,5,0,0,3,0,0,0,1,\n";    // at a time without truth
  const auto run = world.WriteRunFiles("run", kObservationsHeader + rows, kAssociationsHeader);
  const RunEvaluation evaluation = world.Evaluate(run);
  ASSERT_EQ(evaluation.detections.size(), 4u);
  EXPECT_EQ(evaluation.without_truth, 2);
  EXPECT_EQ(evaluation.detections[0].status, "ok");
  EXPECT_EQ(evaluation.detections[1].status, "too_few_edges");
  EXPECT_FALSE(evaluation.detections[1].error);
  EXPECT_EQ(evaluation.detections[2].status, "missing");
  EXPECT_GT(evaluation.detections[2].matches->visible_edges, 0);  // which are all missed
}

TEST(EvalRun, StampsMatchWithinAMillisecond) {
  const TrueWorld world;
  const auto run = world.WriteRunFiles(
      "run", std::string(kObservationsHeader) + "0.0004,0,ok,,1,5,-0.7,0,3,0,0,0,1,\n", kAssociationsHeader);
  const RunEvaluation evaluation = world.Evaluate(run);
  EXPECT_EQ(evaluation.detections[0].status, "ok");
  EXPECT_EQ(evaluation.without_truth, 0);
}

}  // namespace
}  // namespace armature
