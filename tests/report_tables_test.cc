// SPDX-License-Identifier: BSD-3-Clause
// What a report takes from records and tables.
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

ObjectRecord OfAll(const std::string& sequence, const std::string& run, Approach approach,
                   MatchedBy matched_by, std::optional<double> error_m) {
  return {.sequence = sequence,
          .run = run,
          .approach = approach,
          .matched_by = matched_by,
          .found = error_m ? 7 : 0,
          .object_error_mean_m = error_m};
}

EvaluationRecords SomeObjects() {
  constexpr Approach kLoops = Approach::kObjectsLoopClosure;
  EvaluationRecords records;
  ObjectRecord chairs = OfAll("seq1", "run", kLoops, MatchedBy::kDetections, 0.01);
  chairs.category = "chair";
  records.objects = {OfAll("kitchen", "run", Approach::kOdometryOnly, MatchedBy::kDistance, 0.2),
                     OfAll("kitchen", "run", kLoops, MatchedBy::kDistance, 0.0652),
                     OfAll("seq1", "run", Approach::kOdometryOnly, MatchedBy::kDetections, 0.1122),
                     OfAll("seq1", "run", kLoops, MatchedBy::kDistance, 0.0333),
                     chairs,
                     OfAll("seq1", "run", kLoops, MatchedBy::kDetections, 0.049),
                     OfAll("seq1", "other", kLoops, MatchedBy::kDetections, 0.0777),
                     OfAll("seq2", "run", kLoops, MatchedBy::kDistance, std::nullopt)};
  records.paper = {{.sequence = "1", .approach = "ORB", .objects = 7, .object_error_mean_m = 0.457},
                   {.sequence = "1", .approach = "Ours", .objects = 7, .object_error_mean_m = 0.503}};
  return records;
}

TEST(ReportHeadline, LocalizationOfTheFirstRunBesideThePapersSequence) {
  const auto figures = LocalizationFigures(SomeObjects());
  ASSERT_EQ(figures.size(), 2u);  // nothing was found on seq2
  EXPECT_EQ(figures[0].label, "Localization error on kitchen, average");
  EXPECT_EQ(figures[0].ours, "0.0652 m");
  EXPECT_EQ(figures[0].paper, "") << "the paper has no such sequence";
  EXPECT_EQ(figures[1].ours, "0.0490 m") << "by detections, as the paper's table";
  EXPECT_EQ(figures[1].ours_value, 0.049);
  EXPECT_EQ(figures[1].paper, "0.503 m");
  EXPECT_EQ(figures[1].paper_value, 0.503);
  EXPECT_TRUE(figures[1].remark.starts_with("7 objects; objects, loop closure (run)")) << figures[1].remark;
  EXPECT_NE(figures[1].remark.find("a sequence of its own"), std::string::npos) << figures[1].remark;
}

TEST(ReportHeadline, NothingWithoutRecords) {
  EXPECT_TRUE(LocalizationFigures({}).empty());
  EXPECT_TRUE(RetrievalFigures({}).empty());
  EXPECT_TRUE(TimingFigures({}).empty());
}

TEST(ReportHeadline, RetrievalOfTheChairsOfAllSequencesOfTheFirstRun) {
  EvaluationRecords records;
  const auto add = [&](const char* run, std::optional<std::string> sequence, const char* category,
                       double top_1) {
    records.retrieval.push_back({.sequence = std::move(sequence),
                                 .run = run,
                                 .category = category,
                                 .queries = 14,
                                 .top_1_share = top_1,
                                 .top_5_share = 1});
  };
  add("a", "seq1", "chair", 0.5);
  add("a", std::nullopt, "table", 0.6);
  add("a", std::nullopt, "chair", 0.929);
  add("b", std::nullopt, "chair", 0.1);
  const auto figures = RetrievalFigures(records);
  ASSERT_EQ(figures.size(), 2u);  // without Chamfer distance
  EXPECT_EQ(figures[0].ours, "92.9 %");
  EXPECT_EQ(figures[1].ours, "100.0 %");
  EXPECT_FALSE(figures[0].paper_value);
  EXPECT_TRUE(figures[0].remark.starts_with("14 chairs of all sequences")) << figures[0].remark;
}

TEST(ReportAblation, ABarForTheFirstRunWithEachNormalTerm) {
  std::vector<UprightnessRecord> records;
  const auto add = [&](const char* run, const char* term, double pitch_deg) {
    records.push_back(
        {.sequence = "seq1", .run = run, .normal_term = term, .view_pitch_mean_deg = pitch_deg});
  };
  add("default", "axis", 1.25);
  EXPECT_TRUE(NormalTermBars(records).empty());
  add("fast", "axis", 1.5);
  add("without", "none", 2.5);
  const auto all = NormalTermBars(records);
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
  ExpectInputError([&] { RunEnvironment(folder_ / "a"); }, {"a/summary.json", "has to be", "armature run"});
}

}  // namespace
}  // namespace armature
