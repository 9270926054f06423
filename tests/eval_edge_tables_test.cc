// SPDX-License-Identifier: BSD-3-Clause
// The table of edge matches, of matches with known answers.
#include <gtest/gtest.h>

#include "eval/edges/edge_tables.h"
#include "support/edge_world.h"
#include "support/table_cells.h"

namespace armature {
namespace {

using testing::CellText;
using testing::EdgeWorld;

constexpr size_t kChair = 0, kTable = 1, kAll = 2;  // rows

const std::vector<std::string> kShares = {"precision [%]", "recall [%]", "precision by length [%]",
                                          "recall by length [%]"};

void ExpectShares(const Table& table, size_t row, const std::string& prefix,
                  const std::vector<std::string>& values) {
  for (size_t i = 0; i < kShares.size(); ++i)
    EXPECT_EQ(CellText(table, row, prefix + kShares[i]), values[i]) << prefix + kShares[i];
}

Table TableOf(const RunEvaluation& evaluation) { return EdgeTable("world", {{"mine", evaluation}}); }

TEST(EvalEdgeTables, TruthAsResultIsPerfect) {
  const EdgeWorld world;
  const Table table = TableOf(world.Evaluate(testing::RightEdgeMatches()));
  ASSERT_EQ(table.rows.size(), 3u);
  for (const size_t row : {kChair, kTable, kAll}) {
    for (const char* prefix : {"", "~"})
      ExpectShares(table, row, prefix, {"100.0", "100.0", "100.0", "100.0"});
  }
  EXPECT_EQ(CellText(table, kAll, "detections"), "2");
  EXPECT_EQ(CellText(table, kAll, "matches"), "4");
  EXPECT_EQ(CellText(table, kAll, "true edges"), "4");
}

// One right of two, of 100 px and 300 px; 60 px of the table's 160 are found.
TEST(EvalEdgeTables, KnownShares) {
  const EdgeWorld world;
  const Table table =
      TableOf(world.Evaluate({"0.0,0,back_top,100,100,200,100", "0.0,0,back_top,100,110,400,110",
                              "0.0,1,top_front,310,200,370,200"}));
  ExpectShares(table, kChair, "", {"50.0", "50.0", "25.0", "66.7"});
  ExpectShares(table, kChair, "~", {"100.0", "50.0", "100.0", "66.7"});
  ExpectShares(table, kTable, "", {"100.0", "50.0", "100.0", "37.5"});
  ExpectShares(table, kAll, "", {"66.7", "50.0", "34.8", "51.6"});
}

TEST(EvalEdgeTables, NothingMatched) {
  const EdgeWorld world;
  const Table table = TableOf(world.Evaluate({}));
  for (const size_t row : {kChair, kTable, kAll}) {
    EXPECT_EQ(CellText(table, row, "matches"), "0");
    ExpectShares(table, row, "", {"", "0.0", "", "0.0"});
  }
  EXPECT_EQ(FormatTable(table, TableFormat::kText).find("nan"), std::string::npos);
}

TEST(EvalEdgeTables, FalseAlarmsAreOfNoCategory) {
  const EdgeWorld world;
  const Table table = TableOf(world.Evaluate({}, false, "0.2,0,ok,,1,5,0,0,3,0,0,0,1,\n"));
  EXPECT_EQ(CellText(table, kAll, "false alarms"), "2");
  EXPECT_EQ(CellText(table, kAll, "false alarms ok [%]"), "50.0");
  EXPECT_EQ(CellText(table, kChair, "false alarms"), "");
}

TEST(EvalEdgeTables, SaysWhatMatchesAreJudgedBy) {
  const EdgeWorld world;
  EXPECT_NE(testing::NotesText(TableOf(world.Evaluate({}))).find("Truth: edges_gt.csv"), std::string::npos);
  const testing::TrueWorld cad;
  const Table table = TableOf(cad.Evaluate(cad.WriteRun("run", testing::Unchanged, testing::SameName)));
  EXPECT_NE(testing::NotesText(table).find("Truth: CAD models"), std::string::npos);
  ExpectShares(table, kAll, "", {"100.0", "100.0", "100.0", "100.0"});
}

TEST(EvalEdgeTables, AllFormats) {
  const EdgeWorld world;
  const Table table = TableOf(world.Evaluate(testing::RightEdgeMatches()));
  const std::vector<std::pair<TableFormat, std::string>> formats = {
      {TableFormat::kText, "precision by length [%]"},
      {TableFormat::kMarkdown, "| precision by length [%] |"},
      {TableFormat::kCsv, ",precision by length [%],"},
      {TableFormat::kLatex, "\\~{}precision by length [\\%]"},
      {TableFormat::kJson, "\"precision by length [%]\": 100.0"}};
  for (const auto& [format, text] : formats) {
    const std::string formatted = FormatTable(table, format);
    EXPECT_NE(formatted.find(text), std::string::npos) << formatted;
  }
}

TEST(EvalEdgeTables, RawRows) {
  const EdgeWorld world;
  const RunEvaluation evaluation = world.Evaluate(
      {"0.0,0,back_top,100,110,200,110", "0.0,0,back_left,1,2,4,6", "0.0,1,top_rear,300,200,400,200"}, true);
  EXPECT_EQ(RawEdgesCsv({{"mine", evaluation}}),
            "run,sequence,timestamp,index,object,category,edge,true_edge,right,near,distance_px,length_px\n"
            "mine,world,0.000000,0,chair0,chair,back_top,back_top,0,1,10.000,100.000\n"
            "mine,world,0.000000,0,chair0,chair,back_left,back_left,0,0,,5.000\n"
            "mine,world,0.000000,1,table0,table,top_rear,top_front,1,1,0.000,100.000\n");
}

}  // namespace
}  // namespace armature
