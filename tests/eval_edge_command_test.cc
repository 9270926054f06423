// SPDX-License-Identifier: BSD-3-Clause
// The table of edges as users of `armature eval` get it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/edge_world.h"
#include "support/program.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

using testing::EdgeWorld;
using testing::ExpectBadInput;
using testing::RunOk;
using Json = nlohmann::json;

TEST(EvalEdgeCommand, IsShownWhereTheTruthHasEdges) {
  const EdgeWorld world;
  const std::string run = world.WriteRun(testing::RightEdgeMatches()), truth = world.folder / "sequence";
  const auto titles = [&] {
    std::vector<std::string> found;
    for (const auto& table : Json::parse(RunOk({"eval", run, "--groundtruth", truth, "--json"}).out))
      found.push_back(table["title"]);
    return found;
  };
  const std::vector<std::string> with = titles();
  ASSERT_EQ(with.size(), 3u);
  EXPECT_EQ(with[2], "world: matches of edges and segments");
  std::filesystem::remove(world.folder / "sequence/edges_gt.csv");
  EXPECT_EQ(titles().size(), 2u);
}

TEST(EvalEdgeCommand, AloneWithRows) {
  const EdgeWorld world;
  const std::string run = world.WriteRun(testing::RightEdgeMatches());
  const auto tables = Json::parse(RunOk({"eval", run, "--groundtruth", world.folder / "sequence", "--tables",
                                         "edges", "--raw-edges", world.folder / "edges.csv", "--json"})
                                      .out);
  ASSERT_EQ(tables.size(), 1u);
  const auto& all = tables[0]["rows"][2];
  EXPECT_EQ(all["category"], "all");
  EXPECT_EQ(all["precision [%]"], 100.0);
  EXPECT_EQ(all["recall by length [%]"], 100.0);
  EXPECT_EQ(all["false alarms ok [%]"], 0.0);
  const std::string rows = testing::ReadFile(world.folder / "edges.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 5);
  EXPECT_NE(rows.find("run,world,0.000000,1,table0,table,top_rear,top_rear,1,1,0.000,60.000"),
            std::string::npos)
      << rows;
}

TEST(EvalEdgeCommand, BadInput) {
  const EdgeWorld world;
  const std::string run = world.WriteRun({}), truth = world.folder / "sequence";
  world.WriteEdges("0.0,chair0,back_top,100,100,200,100,2\n");
  ExpectBadInput({"eval", run, "--groundtruth", truth}, {"edges_gt.csv:3", "visible"});
  std::filesystem::remove(world.folder / "sequence/edges_gt.csv");
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--tables", "edges"}, {"edges_gt.csv", "--cad"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--raw-edges", world.folder / "edges.csv"},
                 {"edges_gt.csv", "--cad"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--tables", "edge"}, {"'edge'", "edges"});
}

// Nothing is found in a grey image, but it is known what there is to be found.
TEST(BenchCommand, RecallOfTrueEdgesNeedsNoCad) {
  const testing::TempFolder folder;
  WriteTinySequence(folder);
  folder.Write("groundtruth.txt", "0.0 0 0 0 0 0 0 1\n0.2 0 0 0 0 0 0 1\n");
  folder.Write("objects_gt.csv",
               "id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z\n"
               "chair0,chair,,0,0,2,0,0,0,1,0.4,0.8,0.4\n");
  folder.Write("detections_gt.csv", "timestamp,index,id\n0.2,0,chair0\n0.2,1,\n");
  folder.Write("edges_gt.csv", "timestamp,id,edge,x1,y1,x2,y2,visible\n0.2,chair0,back_top,6,10,24,10,1\n");
  const auto json =
      Json::parse(RunOk({"bench", folder.path(), "--tables", "detectors", "--warm-up", "0", "--json"}).out);
  EXPECT_EQ(json["tables"][0]["rows"][0]["recall [%]"], 0.0);
}

}  // namespace
}  // namespace armature
