// SPDX-License-Identifier: BSD-3-Clause
// `armature eval` as its users start it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/evaluation_records.h"
#include "support/program.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::RunOk;
using testing::SameName;
using testing::TrueWorld;
using testing::Unchanged;

TEST(EvalCommand, PrintsTablesAndKeepsRows) {
  const TrueWorld world;
  const auto run = world.WriteRun("run", Unchanged, SameName);
  const auto result = RunOk({"eval", run, "--groundtruth", world.folder / "sequence", "--cad",
                             world.folder / "cad", "--raw", world.folder / "raw.csv", "--json"});
  const auto tables = nlohmann::json::parse(result.out);
  ASSERT_EQ(tables.size(), 2u);
  const auto& all = tables[0]["rows"][2];
  EXPECT_EQ(all["category"], "all");
  EXPECT_EQ(all["translation [%]"], 0.0);
  EXPECT_EQ(all["precision [%]"], 100.0);
  EXPECT_EQ(all["recall [%]"], 100.0);
  EXPECT_NE(testing::ReadFile(world.folder / "raw.csv").find("table0"), std::string::npos);
}

TEST(EvalCommand, FindsTheSequenceInAFolderOfSequences) {
  const TrueWorld world;
  const auto run = world.WriteRun("run", Unchanged, SameName);
  const auto result = RunOk({"eval", run, "--groundtruth", world.folder.path(), "--format", "markdown"});
  EXPECT_NE(result.out.find("| run "), std::string::npos);
}

TEST(EvalCommand, KeepsTablesAndRowsInAFolder) {
  const TrueWorld world;
  const auto run = world.WriteRun("run", Unchanged, SameName);
  const std::string out = world.folder / "evaluation";
  const std::vector<std::string> call{"eval", run, "--groundtruth", world.folder / "sequence", "--out", out};
  const auto printed = RunOk(call).out;
  EXPECT_EQ(testing::ReadFile(out + "/tables.txt"), printed);
  for (const char* file : {"/tables.md", "/tables.csv", "/tables.tex", "/detections.csv"})
    EXPECT_FALSE(testing::ReadFile(out + file).empty()) << file;
  const auto json = nlohmann::json::parse(testing::ReadFile(out + "/eval.json"));
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["tables"][0]["table"], "observations");
  EXPECT_EQ(json["tables"][0]["sequence"], "world");
  const EvaluationRecords records = ReadEvaluationRecords(out + "/records.json");
  ASSERT_EQ(records.runs.size(), 1u);
  EXPECT_EQ(records.runs[0].folder, run);
  EXPECT_EQ(records.runs[0].run, "run");
  const auto& row = json["tables"][0]["rows"][2];  // after chair and table: all
  const ViewRecord& all = records.views.at(2);
  EXPECT_FALSE(all.category);
  EXPECT_EQ(all.detections, row["detections"]);
  EXPECT_EQ(100 * all.views_within_15_deg_share.value(), row["within 15 deg [%]"]);
  RunOk(call);  // a finished one is replaced, anything else is not
  ExpectBadInput(
      {"eval", run, "--groundtruth", world.folder / "sequence", "--out", world.folder / "sequence"},
      {"sequence", "a finished evaluation"});
}

TEST(EvalCommand, BadInput) {
  const TrueWorld world;
  const auto run = world.WriteRun("run", Unchanged, SameName);
  const std::string truth = world.folder / "sequence";
  ExpectBadInput({"eval", run}, {"world", "--groundtruth"});
  ExpectBadInput({"eval", world.folder / "sequence", "--groundtruth", truth},
                 {"sequence", "not a finished run"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--cad", world.folder / "run"},
                 {"annotated CAD models"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--format", "excel"}, {"excel"});
}

}  // namespace
}  // namespace armature
