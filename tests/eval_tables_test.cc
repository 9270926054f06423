// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "eval/eval_inputs.h"
#include "eval/views/evaluation_tables.h"
#include "support/table_cells.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::CellText;
using testing::SameName;
using testing::TrueWorld;
using testing::Unchanged;

TEST(EvalTables, PerfectRun) {
  const TrueWorld world;
  const RunEvaluation evaluation = world.Evaluate(world.WriteRun("run", Unchanged, SameName));
  const std::vector<Table> tables = EvaluationTables("world", {{"mine", evaluation}});
  ASSERT_EQ(tables.size(), 2u);
  for (const Table& table : tables) {
    ASSERT_EQ(table.rows.size(), 3u);  // chair, table, all
    for (size_t row = 0; row < 3; ++row) {
      EXPECT_EQ(CellText(table, row, "azimuth [deg]"), "0.00");
      EXPECT_EQ(CellText(table, row, "translation [%]"), "0.00");
      EXPECT_EQ(CellText(table, row, "within 15 deg [%]"), "100.0");
      EXPECT_EQ(CellText(table, row, "precision [%]"), "100.0");
      EXPECT_EQ(CellText(table, row, "recall [%]"), "100.0");
    }
    EXPECT_EQ(CellText(table, 2, "category"), "all");
    EXPECT_EQ(CellText(table, 2, "detections"), "4");
  }
}

// A run that found nothing is not a good run: everything is missing, nothing is nan.
TEST(EvalTables, EmptyRunHasDashes) {
  const TrueWorld world;
  const auto run = world.WriteRunFiles(
      "run", "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n",
      "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n");
  const std::vector<Table> tables = EvaluationTables("world", {{"mine", world.Evaluate(run)}});
  EXPECT_EQ(CellText(tables[0], 2, "detections"), "4");
  EXPECT_EQ(CellText(tables[0], 2, "estimates"), "0");
  EXPECT_EQ(CellText(tables[0], 2, "ok [%]"), "0.0");
  EXPECT_EQ(CellText(tables[0], 2, "azimuth [deg]"), "");
  EXPECT_EQ(CellText(tables[0], 2, "within 15 deg [%]"), "0.0");
  EXPECT_EQ(CellText(tables[0], 2, "precision [%]"), "");
  EXPECT_EQ(CellText(tables[0], 2, "recall [%]"), "0.0");
  EXPECT_EQ(CellText(tables[1], 2, "within 15 deg [%]"), "");
  for (const Table& table : tables) {
    EXPECT_EQ(FormatTable(table, TableFormat::kText).find("nan"), std::string::npos);
  }
}

// Half of the chairs is left out: the share within 15 degrees does not profit from it.
TEST(EvalTables, MissingOnesAreNotWithin15Degrees) {
  const TrueWorld world;
  RunEvaluation evaluation = world.Evaluate(world.WriteRun("run", Unchanged, SameName));
  evaluation.detections[0].error.reset();
  evaluation.detections[0].status = "diverged";
  const std::vector<Table> tables = EvaluationTables("world", {{"mine", evaluation}});
  EXPECT_EQ(CellText(tables[0], 0, "estimates"), "1");
  EXPECT_EQ(CellText(tables[0], 0, "within 15 deg [%]"), "50.0");
  EXPECT_EQ(CellText(tables[1], 0, "within 15 deg [%]"), "100.0");
}

TEST(EvalTables, FalseAlarmsAreMentioned) {
  RunEvaluation evaluation;
  evaluation.without_truth = 3;
  const std::vector<Table> tables = EvaluationTables("world", {{"mine", evaluation}});
  EXPECT_NE(FormatTable(tables[0], TableFormat::kText).find("mine: 3 detections are of no true object"),
            std::string::npos);
}

TEST(EvalTables, RawRows) {
  const TrueWorld world;
  const RunEvaluation evaluation = world.Evaluate(world.WriteRun("run", Unchanged, SameName));
  const std::string csv = RawCsv({{"mine", evaluation}});
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_NE(csv.find("mine,world,0.200000,1,table0,table,ok,0.0000,0.0000,0.0000,0.0000,"), std::string::npos)
      << csv;
}

TEST(EvalTables, RunNames) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(RunNames({"out/default/office", "out/paper/office/"}, "office"), (Names{"default", "paper"}));
  EXPECT_EQ(RunNames({"out/first", "out/second"}, "office"), (Names{"first", "second"}));
  EXPECT_EQ(RunNames({"a/run", "b/run"}, "office"), (Names{"a/run", "b/run"}));
}

}  // namespace
}  // namespace armature
