// SPDX-License-Identifier: BSD-3-Clause
// The objects of the map in `armature eval`, as its users start it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/true_map.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::MapText;
using testing::ReadFile;
using testing::RunOk;
using testing::SameName;
using testing::TrueMap;
using testing::TrueWorld;
using testing::Unchanged;
using Json = nlohmann::json;

class EvalObjectsCommand : public ::testing::Test {
 protected:
  EvalObjectsCommand() {
    world_.folder.Write("sequence/objects_gt.csv",
                        "# measured by hand\n" + ReadFile(world_.folder / "sequence/objects_gt.csv"));
    AddRun("mine", "resection:\n  normal_term: axis\nmapping:\n  loop_closure: true\n");
  }

  // A run that is true in another world: the camera's first pose is its origin.
  void AddRun(const std::string& name, const std::string& configuration) const {
    Similarity T_run_truth;
    T_run_truth.R = ExpSO3({0.5, 0, 1});
    T_run_truth.t = {1, 2, 3};
    world_.WriteRun(name, Unchanged, SameName);
    WriteMap(world_, name, TrueMap(world_.sequence.truth), T_run_truth);
    world_.folder.Write(name + "/config.yaml", configuration);
  }

  std::vector<std::string> Command(const std::vector<std::string>& more) const {
    std::vector<std::string> command{"eval", world_.folder / "mine", "--groundtruth",
                                     world_.folder / "sequence"};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }

  static std::string Notes(const Json& table) {
    std::string notes;
    for (const auto& note : table["notes"]) notes += note.get<std::string>() + "\n";
    return notes;
  }

  TrueWorld world_;
};

TEST_F(EvalObjectsCommand, TruthAsResultIsPerfect) {
  const auto result = RunOk(Command({"--tables", "objects,each_object", "--json"}));
  const Json tables = Json::parse(result.out);
  ASSERT_EQ(tables.size(), 2u);
  ASSERT_EQ(tables[0]["rows"].size(), 6u);  // odometry and objects; chair, table, all
  const Json& all = tables[0]["rows"][5];
  EXPECT_EQ(all["run"], "mine");
  EXPECT_EQ(all["approach"], "objects, loop closure");
  EXPECT_EQ(all["found"], 2);
  EXPECT_EQ(all["observed"], 2);
  EXPECT_EQ(all["spurious"], 0);
  EXPECT_EQ(all["worst [m]"], 0.0);
  EXPECT_EQ(all["azimuth [deg]"], 0.0);
  EXPECT_EQ(all["size [m]"], 0.0);
  EXPECT_EQ(all["IoU"], 1.0);
  EXPECT_NE(Notes(tables[0]).find("measured by hand"), std::string::npos);
  EXPECT_NE(Notes(tables[0]).find("alignment first_pose"), std::string::npos);
  EXPECT_EQ(tables[1]["rows"].size(), 4u);
  EXPECT_EQ(tables[1]["rows"][0]["map object"], "map_chair0");
}

TEST_F(EvalObjectsCommand, WithoutAlignmentTheWorldsDiffer) {
  const auto result = RunOk(Command({"--tables", "objects", "--object-alignment", "none", "--json"}));
  const Json tables = Json::parse(result.out);
  EXPECT_EQ(tables[0]["rows"][5]["found"], 0);
  EXPECT_EQ(tables[0]["rows"][5]["missed"], 2);
  EXPECT_EQ(tables[0]["rows"][5]["average [m]"], nullptr);
}

TEST_F(EvalObjectsCommand, PaperTableOfSeveralRuns) {
  AddRun("open", "resection:\n  normal_term: none\nmapping:\n  loop_closure: false\n");
  const auto result = RunOk({"eval", world_.folder / "mine", world_.folder / "open", "--groundtruth",
                             world_.folder / "sequence", "--tables", "normal,paper", "--format", "json"});
  const Json tables = Json::parse(result.out);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0]["rows"][1]["run"], "open");
  EXPECT_EQ(tables[0]["rows"][1]["normal term"], "none");
  EXPECT_EQ(tables[0]["rows"][1]["objects"], 2);
  EXPECT_EQ(tables[0]["rows"][1]["observations"], 4);
  EXPECT_EQ(tables[0]["rows"][1]["observations: pitch mean"], 0.0);
  const Json& paper = tables[1]["rows"];
  ASSERT_EQ(paper.size(), 10u);
  EXPECT_EQ(paper[0]["Sequence"], "world");
  EXPECT_EQ(paper[0]["Approach"], "odometry only (mine)");
  EXPECT_EQ(paper[1]["Approach"], "objects, loop closure");
  EXPECT_EQ(paper[3]["Approach"], "objects, no loop closure");
  EXPECT_EQ(paper[3]["# Objects"], 2);
  EXPECT_EQ(paper[3]["Average"], 0.0);
  EXPECT_EQ(paper[9]["Sequence"], "paper 3");
  EXPECT_EQ(paper[9]["Average"], 3.85);
}

TEST_F(EvalObjectsCommand, KeepsRows) {
  RunOk(Command({"--raw-objects", world_.folder / "objects.csv"}));
  const std::string rows = ReadFile(world_.folder / "objects.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 5) << rows;
  EXPECT_NE(rows.find("mine,world,axis,true,odometry,first_pose,1.000000000,distance,found,chair0,chair,map_"
                      "chair0,5,0.00"),
            std::string::npos)
      << rows;
}

TEST_F(EvalObjectsCommand, AllTablesWithoutChoice) {
  const std::string out = RunOk(Command({})).out;
  for (const char* title : {"world: all estimates", "world: objects of the map", "world: each object",
                            "world: pitch and roll", "as the paper tells it"}) {
    EXPECT_NE(out.find(title), std::string::npos) << title;
  }
}

TEST_F(EvalObjectsCommand, RunsWithoutMap) {
  for (const char* file : {"mine/objects.csv", "mine/objects_odometry.csv", "mine/trajectory.txt"})
    std::filesystem::remove(world_.folder / file);
  const auto left_out = RunOk(Command({"--json"}));
  EXPECT_EQ(Json::parse(left_out.out).size(), 2u) << "observations alone";
  EXPECT_NE(left_out.err.find("no run on it has an objects.csv"), std::string::npos) << left_out.err;
  const Json asked = Json::parse(RunOk(Command({"--tables", "objects", "--json"})).out);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_TRUE(asked[0]["rows"].empty());
  EXPECT_NE(Notes(asked[0]).find("mine: left out"), std::string::npos);
}

TEST_F(EvalObjectsCommand, AMapWithoutObjects) {
  for (const char* file : {"mine/objects.csv", "mine/objects_odometry.csv"})
    world_.folder.Write(file, MapText({}));
  const std::string out = RunOk(Command({})).out;
  EXPECT_EQ(out.find("nan"), std::string::npos) << out;
  const Json tables = Json::parse(RunOk(Command({"--tables", "objects", "--json"})).out);
  EXPECT_EQ(tables[0]["rows"][5]["missed"], 2);
}

TEST_F(EvalObjectsCommand, BadInput) {
  ExpectBadInput(Command({"--tables", "object"}), {"object", "objects"});
  ExpectBadInput(Command({"--gate", "0"}), {"--gate"});
  ExpectBadInput(Command({"--object-alignment", "firstpose"}), {"firstpose", "first_pose"});
  ExpectBadInput(Command({"--paper-numbers", world_.folder / "absent.csv"}), {"absent.csv"});
  ExpectBadInput(Command({"--raw-objects", world_.folder / "mine/objects.csv/rows.csv"}), {"rows.csv"});
  world_.folder.Write("mine/objects.csv", "id,category\n");
  ExpectBadInput(Command({}), {"mine/objects.csv:1", "instance"});
}

}  // namespace
}  // namespace armature
