// SPDX-License-Identifier: BSD-3-Clause
// `armature substitute`, and what becomes of its sequences, as its users start it.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/substitution_world.h"
#include "support/true_map.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using testing::ExpectBadInput;
using testing::ReadFile;
using testing::RunOk;
using testing::SubstitutionWorld;
using Json = nlohmann::json;

std::map<std::string, std::string> Contents(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const std::string& file : testing::AllFiles(folder)) contents[file] = ReadFile(folder / file);
  return contents;
}

class SubstituteCommand : public ::testing::Test {
 protected:
  std::vector<std::string> Command(const std::string& truths) const {
    return {"substitute", world_.sequence_folder(), "--truth", truths, "--out", out()};
  }
  std::string out() const { return world_.folder / "out"; }
  // A run that has the true map of a sequence, whose first object is off to the side.
  std::string AddRun(const std::string& name, const fs::path& sequence, double off_m) const {
    auto map = testing::TrueMap(LoadGroundTruth(sequence));
    map.front().T_world_object.translation().x() += off_m;
    const std::string folder = "runs/" + name + "/world";
    world_.WriteRunFiles(folder,
                         "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape\n",
                         "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n");
    WriteMap(world_, folder, map, {});
    world_.folder.Write(folder + "/config.yaml", "mapping:\n  loop_closure: true\n");
    const Json summary{{"sequence", "world"}, {"sequence_folder", sequence.string()}, {"complete", true}};
    world_.folder.Write(folder + "/summary.json", summary.dump());
    return world_.folder / ("runs/" + name);
  }

  SubstitutionWorld world_;
};

TEST_F(SubstituteCommand, LinksWhatItDoesNotReplaceAndLeavesTheSequenceAlone) {
  const auto before = Contents(world_.sequence_folder());
  const std::string printed = RunOk(Command("scale,identities")).out;
  EXPECT_EQ(printed, out() + "/scale/world\n" + out() + "/identities/world\n") << "in the order of --truth";
  EXPECT_EQ(Contents(world_.sequence_folder()), before);
  const fs::path scale = fs::path(out()) / "scale/world";
  EXPECT_TRUE(fs::is_symlink(scale / "detections.csv"));
  EXPECT_FALSE(fs::is_symlink(scale / "odometry.txt"));
  EXPECT_EQ(ReadFile(scale / "segments.csv"), before.at("segments.csv"));
  const Json mark = Json::parse(ReadFile(scale / "substituted.json"));
  EXPECT_EQ(mark["sequence"], world_.sequence_folder().string());
  EXPECT_EQ(mark["truth"], Json::array({"scale"}));
}

TEST_F(SubstituteCommand, TruthsAddUp) {
  RunOk(Command("identities"));
  const std::string more = world_.folder / "more";
  RunOk({"substitute", out() + "/identities/world", "--truth", "scale,lines", "--out", more});
  EXPECT_TRUE(fs::exists(more + "/scale/world/categories/chair0.yaml"));
  const Json mark = Json::parse(ReadFile(more + "/lines/world/substituted.json"));
  EXPECT_EQ(mark["truth"], Json::array({"identities", "lines"}));
  EXPECT_EQ(mark["sequence"], world_.sequence_folder().string());
}

TEST_F(SubstituteCommand, ReplacesItsOwnFoldersAndRefusesOthers) {
  RunOk(Command("scale"));
  RunOk(Command("scale"));
  EXPECT_EQ(testing::AllFiles(out() + "/scale").count("world"), 1u);
  world_.folder.Write("out/cameras/world/mine.txt", "precious");
  ExpectBadInput(Command("lines,cameras"), {"cameras/world", "armature substitute"});
  EXPECT_FALSE(fs::exists(out() + "/lines/world")) << "nothing is written when something cannot be";
  EXPECT_EQ(ReadFile(out() + "/cameras/world/mine.txt"), "precious");
}

TEST_F(SubstituteCommand, ARunOnItIsJudgedByItsOwnTruth) {
  RunOk(Command("identities"));
  const std::string sequence = out() + "/identities/world", categories = sequence + "/categories";
  const std::string run = world_.folder / "run";
  RunOk({"run", sequence, "--out", run, "--categories", categories});
  const Json tables =
      Json::parse(RunOk({"eval", run, "--categories", categories, "--tables", "observations", "--json"}).out);
  EXPECT_EQ(tables[0]["rows"][0]["category"], "chair0");
  EXPECT_EQ(tables[0]["rows"][0]["detections"], 2);
}

TEST_F(SubstituteCommand, RunsOnWhatWasMadeOfARoomAreComparedOverRooms) {
  RunOk(Command("detections,identities"));
  const std::string none = AddRun("none", world_.sequence_folder(), 0.5);
  const std::string better = AddRun("detections", out() + "/detections/world", 0.3);
  const std::string best = AddRun("identities", out() + "/identities/world", 0.1);
  const Json table =
      Json::parse(RunOk({"eval", none, better, best, "--tables", "error_budget", "--json"}).out)[0];
  ASSERT_EQ(table["rows"].size(), 3u);
  EXPECT_EQ(table["rows"][2]["truth given"], "identities");
  EXPECT_EQ(table["rows"][2]["found [%]"], 100.0);
  EXPECT_EQ(table["rows"][0]["error an object [m]"], 0.25);
  EXPECT_EQ(table["rows"][1]["error an object [m]"], 0.15);
  EXPECT_EQ(table["rows"][2]["error an object [m]"], 0.05);
  ExpectBadInput({"eval", none, best, "--tables", "rooms,objects"}, {"another sequence 'world'"});
}

TEST_F(SubstituteCommand, BadInput) {
  ExpectBadInput(Command("scales"), {"--truth", "'scales'", "scale"});
  ExpectBadInput(
      {"substitute", world_.sequence_folder(), world_.sequence_folder(), "--truth", "scale", "--out", out()},
      {"'world'", "give one"});
  ExpectBadInput({"substitute", world_.folder / "absent", "--truth", "scale", "--out", out()}, {"absent"});
  fs::remove(world_.folder / "sequence/edges_gt.csv");
  ExpectBadInput(Command("scale,lines"), {"edges_gt.csv", "'lines'", "--truth"});
  EXPECT_FALSE(fs::exists(out() + "/scale/world")) << "nothing is written when something cannot be";
}

TEST_F(SubstituteCommand, ASequenceThatIsItsOwnOutputIsBadInput) {
  RunOk(Command("scale"));
  ExpectBadInput({"substitute", out() + "/scale/world", "--truth", "scale", "--out", out()},
                 {"the sequence itself"});
}

}  // namespace
}  // namespace armature
