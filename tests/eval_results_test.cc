// SPDX-License-Identifier: BSD-3-Clause
// Reading run folders, and naming what is wrong with them.
#include <gtest/gtest.h>

#include "support/expect_input_error.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::TempFolder;

const std::string kObservations =
    "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n"
    "0.2,0,ok,,1,5,0,0,3,0,0,0,1,\n";
const std::string kAssociations = "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n";
const std::string kSummary = "{\"sequence\": \"world\", \"complete\": true}";

class RunFolders : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& observations,
                              const std::string& associations = kAssociations,
                              const std::string& summary = kSummary) const {
    folder_.Write("run/observations.csv", observations);
    folder_.Write("run/associations.csv", associations);
    folder_.Write("run/summary.json", summary);
    return folder_ / "run";
  }
  void ExpectRefused(const std::filesystem::path& run, const std::vector<std::string>& texts) const {
    ExpectInputError([&] { LoadRun(run); }, texts);
  }

  TempFolder folder_;
};

TEST_F(RunFolders, AGoodOne) {
  const RunResults run = LoadRun(Write(kObservations, kAssociations + "0.2,0,hinge,1,2,3,4,0.5\n"));
  EXPECT_EQ(run.sequence, "world");
  ASSERT_EQ(run.observations.size(), 1u);
  const RunObservation* observation = run.Find(0.2005, 0);
  ASSERT_NE(observation, nullptr);
  EXPECT_EQ(observation->T_camera_object->translation(), Eigen::Vector3d(0, 0, 3));
  ASSERT_EQ(observation->matches.size(), 1u);
  EXPECT_EQ(observation->matches[0].edge, "hinge");
  EXPECT_EQ(run.Find(0.2, 1), nullptr);
  EXPECT_EQ(run.Find(0.4, 0), nullptr);
}

TEST_F(RunFolders, Unfinished) {
  ExpectRefused(Write(kObservations, kAssociations, "{\"sequence\": \"world\"}"), {"run", "complete"});
  ExpectRefused(folder_ / "absent", {"absent", "complete"});
}

TEST_F(RunFolders, WithoutSequence) {
  ExpectRefused(Write(kObservations, kAssociations, "{\"complete\": true}"), {"summary.json", "sequence"});
}

TEST_F(RunFolders, MalformedObservations) {
  const std::string header = kObservations.substr(0, kObservations.find('\n') + 1);
  ExpectRefused(Write(header + "0.2,x,ok,,1,5,0,0,3,0,0,0,1,\n"), {"observations.csv:2", "index"});
  ExpectRefused(Write(header + "0.2,0,ok,,1,5,0,,3,0,0,0,1,\n"), {"observations.csv:2", "pose"});
  ExpectRefused(Write(header + "0.2,0,ok,,1,5,0,0,3,0,0,0,2,\n"), {"observations.csv:2", "quaternion"});
  ExpectRefused(Write(kObservations + "0.2,0,ok,,1,5,0,0,3,0,0,0,1,\n"), {"observations.csv:3", "twice"});
  ExpectRefused(Write("timestamp,index\n"), {"observations.csv:1", "status"});
}

TEST_F(RunFolders, AssociationsOfAnotherRun) {
  ExpectRefused(Write(kObservations, kAssociations + "0.2,3,hinge,1,2,3,4,0.5\n"), {"associations.csv:2"});
}

TEST_F(RunFolders, AnEmptyRun) {
  const std::string header = kObservations.substr(0, kObservations.find('\n') + 1);
  EXPECT_TRUE(LoadRun(Write(header)).observations.empty());
}

TEST_F(RunFolders, AFolderOfRuns) {
  Write(kObservations);
  EXPECT_EQ(RunsIn(folder_ / "run"), std::vector{folder_ / "run"});
  EXPECT_EQ(RunsIn(folder_.path()), std::vector{folder_ / "run"});
  ExpectInputError([&] { RunsIn(folder_ / "absent"); }, {"absent"});
}

TEST_F(RunFolders, UnknownEdgeName) {
  const testing::TrueWorld world;
  const auto run = world.WriteRunFiles("run", kObservations, kAssociations + "0.2,0,back_topp,1,2,3,4,0.5\n");
  ExpectInputError([&] { world.Evaluate(run); }, {"associations.csv", "back_topp", "back_top"});
}

TEST_F(RunFolders, MissingTruth) {
  const testing::TrueWorld world;
  std::filesystem::remove(world.folder / "sequence/objects_gt.csv");
  ExpectInputError([&] { LoadSequenceTruth(world.folder / "sequence", {}); }, {"objects_gt.csv"});
}

TEST_F(RunFolders, TruthOfAnUnknownCategory) {
  const testing::TrueWorld world;
  const RunResults run = LoadRun(Write(kObservations));
  ExpectInputError([&] { EvaluateRun(run, world.sequence, {}, CadLibrary()); }, {"chair", "--categories"});
}

}  // namespace
}  // namespace armature
