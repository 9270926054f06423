// SPDX-License-Identifier: BSD-3-Clause
// What a report takes from tables.
#include <gtest/gtest.h>

#include "eval/report/ablation_bars.h"
#include "eval/report/headline.h"
#include "eval/report/run_environment.h"
#include "eval/report/table_json.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;

Table PaperLikeTable() {
  Table table;
  table.name = "paper";
  table.columns = {"Sequence", "Approach", "# Objects", "Best", "Worst", "Average"};
  const auto row = [&](const char* sequence, const char* approach, long objects, const std::string& average) {
    table.rows.push_back({TextCell(sequence), TextCell(approach), CountCell(objects), NoCell(), NoCell(),
                          Cell{average, !average.empty()}});
  };
  row("kitchen", "odometry only", 6, "0.2000");
  row("kitchen", "objects, loop closure", 6, "0.0652");
  row("seq1", "odometry only", 7, "0.1122");
  row("seq1", "objects, loop closure (run)", 7, "0.0490");
  row("seq1", "objects, loop closure (other)", 7, "0.0777");
  row("seq2", "objects, loop closure", 0, "");
  row("paper 1", "ORB", 7, "0.457");
  row("paper 1", "Ours", 7, "0.5030");
  return table;
}

TEST(ReportHeadline, LocalizationOfTheFirstRunBesideThePapersSequence) {
  const auto figures = LocalizationFigures({PaperLikeTable()});
  ASSERT_EQ(figures.size(), 2u);  // nothing was found on seq2
  EXPECT_EQ(figures[0].label, "Localization error on kitchen, average");
  EXPECT_EQ(figures[0].ours, "0.0652 m");
  EXPECT_EQ(figures[0].paper, "") << "the paper has no such sequence";
  EXPECT_EQ(figures[1].ours, "0.0490 m");
  EXPECT_EQ(figures[1].ours_value, 0.049);
  EXPECT_EQ(figures[1].paper, "0.5030 m");
  EXPECT_EQ(figures[1].paper_value, 0.503);
  EXPECT_NE(figures[1].remark.find("a sequence of its own"), std::string::npos) << figures[1].remark;
}

TEST(ReportHeadline, NothingWithoutTables) {
  EXPECT_TRUE(LocalizationFigures({}).empty());
  EXPECT_TRUE(RetrievalFigures({}).empty());
  EXPECT_TRUE(TimingFigures({}).empty());
}

TEST(ReportHeadline, RetrievalOfTheChairsOfAllSequencesOfTheFirstRun) {
  Table table;
  table.name = "retrieval";
  table.columns = {"run", "sequence", "category", "queries", "top-1 [%]", "top-5 [%]", "Chamfer [cm]"};
  const auto row = [&](const char* run, const char* sequence, const char* category, double top_1) {
    table.rows.push_back({TextCell(run), TextCell(sequence), TextCell(category), CountCell(14),
                          NumberCell(top_1, 1), NumberCell(100, 1), NoCell()});
  };
  row("a", "seq1", "chair", 50);
  row("a", "all", "table", 60);
  row("a", "all", "chair", 92.9);
  row("b", "all", "chair", 10);
  const auto figures = RetrievalFigures({table});
  ASSERT_EQ(figures.size(), 2u);  // without Chamfer distance
  EXPECT_EQ(figures[0].ours, "92.9 %");
  EXPECT_EQ(figures[1].ours, "100.0 %");
  EXPECT_FALSE(figures[0].paper_value);
  EXPECT_TRUE(figures[0].remark.starts_with("14 chairs of all sequences")) << figures[0].remark;
}

TEST(ReportAblation, ABarForTheFirstRunWithEachNormalTerm) {
  Table table;
  table.name = "normal";
  table.sequence = "seq1";
  table.columns = {"run", "normal term", "observations: pitch mean", "objects: pitch mean"};
  const auto row = [&](const char* run, const char* term, double pitch) {
    table.rows.push_back({TextCell(run), TextCell(term), NumberCell(pitch, 2), NoCell()});
  };
  row("default", "axis", 1.25);
  EXPECT_TRUE(NormalTermBars({table}).empty());
  row("fast", "axis", 1.5);
  row("without", "none", 2.5);
  const auto all = NormalTermBars({table});
  ASSERT_EQ(all.size(), 1u);  // of objects nothing was measured
  EXPECT_EQ(all[0].sequence, "seq1");
  EXPECT_EQ(all[0].caption, "Mean absolute pitch of observations");
  ASSERT_EQ(all[0].bars.size(), 2u);
  EXPECT_EQ(all[0].bars[0].run, "axis: default");
  EXPECT_EQ(all[0].bars[0].value, 1.25);
  EXPECT_EQ(all[0].bars[1].run, "none: without");
  EXPECT_EQ(all[0].bars[1].value, 2.5);
}

class ReportTableFiles : public ::testing::Test {
 protected:
  void ExpectRefusedTable(const std::string& written, const std::string& text) const {
    const auto file = folder_.Write("t.json", written);
    ExpectInputError([&] { ReadTables(file); }, {file.string(), text, "again"});
  }
  testing::TempFolder folder_;
};

TEST_F(ReportTableFiles, ComeBackAsTheyWereWritten) {
  Table table{"Title", {"run", "error [m]", "n"}, {}, {"A note."}, "objects", "seq1"};
  table.rows = {{TextCell("a"), NumberCell(0.045, 4), CountCell(10)},
                {NoCell(), NumberCell(1.1234, 4), NoCell()},
                {TextCell("b"), NumberCell(-2, 4), CountCell(0)}};
  const std::string written = FormatTable(table, TableFormat::kJson);
  for (const std::string& text : {written, "[" + written + "]", "{\"tables\": [" + written + "]}"}) {
    const std::vector<Table> read = ReadTables(folder_.Write("t.json", text));
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].name, "objects");
    EXPECT_EQ(read[0].sequence, "seq1");
    EXPECT_EQ(FormatTable(read[0], TableFormat::kText), FormatTable(table, TableFormat::kText));
  }
}

TEST_F(ReportTableFiles, BadOnesAreRefused) {
  const auto file = folder_.Write("t.json", "{\"tables\": [");
  ExpectInputError([&] { ReadTables(file); }, {file.string(), "is not JSON", "--json"});
  ExpectRefusedTable("7", "it is no object");
  ExpectRefusedTable("{\"tables\": 7}", "it is no object");
  ExpectRefusedTable(R"({"title": 7, "columns": [], "rows": [], "notes": []})", "'title' is no text");
  ExpectRefusedTable(R"({"columns": ["a", 1], "rows": [], "notes": []})", "'columns' is no list of texts");
  ExpectRefusedTable(R"({"columns": ["a"], "notes": []})", "it has no rows");
  ExpectRefusedTable(R"({"columns": ["a"], "rows": [{"b": 1}], "notes": []})", "a row has no 'a'");
  ExpectRefusedTable(R"({"columns": ["a"], "rows": [{"a": [1]}], "notes": []})", "neither text nor number");
}

TEST_F(ReportTableFiles, EnvironmentOfRunsIsMerged) {
  const auto summary = [](const std::string& commit) {
    return R"({"version": "0.1.0", "git": {"commit": ")" + commit +
           R"(", "dirty": true}, "machine": {"cpu": "X", "cores": 2}, "versions": {"eigen": "3.4.0"}})";
  };
  folder_.Write("a/summary.json", summary("abc"));
  folder_.Write("b/summary.json", summary("def"));
  EnvironmentEntries all;
  for (const char* run : {"a", "b", "a"}) MergeEnvironment(RunEnvironment(folder_ / run), all);
  const EnvironmentEntries expected{{"armature", "0.1.0"},
                                    {"commit", "abc, modified; def, modified"},
                                    {"machine", "X, 2 cores"},
                                    {"eigen", "3.4.0"}};
  EXPECT_EQ(all, expected);
  folder_.Write("a/summary.json", R"({"git": {"commit": 7}})");
  ExpectInputError([&] { RunEnvironment(folder_ / "a"); },
                   {"a/summary.json", "is malformed", "armature run"});
}

}  // namespace
}  // namespace armature
