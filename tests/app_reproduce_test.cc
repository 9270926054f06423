// SPDX-License-Identifier: BSD-3-Clause
// `armature reproduce` from end to end, on the small scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "io/evaluation_records.h"
#include "support/small_scene.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::CopySmallScene;
using testing::ExpectBadInput;
using testing::ProgramResult;
using testing::ReadFile;
using testing::RunProgram;
using testing::TempFolder;

constexpr const char* kDenMatrix = R"(name: den
sequences: [out/den]
variants:
  - {name: objects, about: all objects}
  - {name: odometry, about: odometry, odometry_of: objects}
  - {name: broken, about: a detector that is not there, config: broken.yaml}
)";

// The small scene and a matrix of it.
class ReproduceSmallScene : public ::testing::Test {
 protected:
  void SetUp() override {
    CopySmallScene(folder_, 3);
    folder_.Write("broken.yaml", "lines: {detector: sonar}\n");
    config_ = folder_.Write("den.yaml", kDenMatrix);
  }
  ProgramResult Reproduce(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"reproduce", "--config", config_, "--out", folder_ / "results"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
  }
  std::string InResults(const std::string& file) const { return ReadFile(folder_ / "results/latest" / file); }

  const testing::StartedAnew anew_;  // it starts itself
  TempFolder folder_;
  std::string config_;
};

TEST_F(ReproduceSmallScene, LeavesResultsATableAndAReportAndTellsWhatFailed) {
  const ProgramResult result = Reproduce();
  EXPECT_EQ(result.status, 1) << "a variant failed";
  EXPECT_NE(result.err.find("runs/broken/den failed"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("failed: "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("report.html"), std::string::npos) << result.out;
  for (const char* file :
       {"report.html", "README.txt", "tables.md", "tables.tex", "runs/objects/den/objects.csv",
        "evaluation/accuracy/detections.csv", "jobs/runs/broken/den.log"})
    EXPECT_FALSE(InResults(file).empty()) << file;
  EXPECT_FALSE(fs::exists(folder_ / "results/den.partial"));
  const json environment = json::parse(InResults("environment.json"));
  EXPECT_EQ(environment["jobs"]["failed"], 1);
  EXPECT_EQ(environment["complete"], true);
  const json tables = json::parse(InResults("tables.json"));
  ASSERT_EQ(tables[0]["rows"].size(), 3u);
  EXPECT_EQ(tables[0]["rows"][0]["outcome"], "done");
  EXPECT_NE(std::string(tables[0]["rows"][2]["outcome"]).find("sonar"), std::string::npos);
  EXPECT_NE(InResults("report.html").find("sonar"), std::string::npos) << "the reason is in the report, too";
}

TEST_F(ReproduceSmallScene, SaysWhatFailedAlsoWhenItIsQuiet) {
  const ProgramResult result = Reproduce({"--quiet", "--only", "broken"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("runs/broken/den"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("sonar"), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST_F(ReproduceSmallScene, TheMainTableHasTheNumbersOfTheRecords) {
  // Frames enough for a map. Runs are named by folders, records by sequences.
  const std::string scene = folder_.Write(
      "long.yaml", std::regex_replace(testing::kSmallScene, std::regex("frames: 4"), "frames: 12"));
  fs::remove_all(folder_ / "out");
  testing::RunOk({"generate", "--scene", scene, "--without-cad", "--out", folder_ / "out"});
  fs::rename(folder_ / "out/den", folder_ / "out/closet");
  folder_.Write("den.yaml", std::regex_replace(kDenMatrix, std::regex("out/den"), "out/closet"));
  ASSERT_EQ(Reproduce({"--only", "objects,odometry", "--name", "den"}).status, 0);
  const EvaluationRecords records =
      ReadEvaluationRecords(folder_ / "results/latest/evaluation/accuracy/records.json");
  const json rows = json::parse(InResults("tables.json"))[0]["rows"];
  ASSERT_EQ(rows.size(), 2u);
  int compared = 0;
  for (const ObjectRecord& record : records.objects) {
    if (record.category || record.matched_by != MatchedBy::kDistance) continue;
    const json& row = rows[record.approach == Approach::kOdometryOnly ? 1 : 0];
    EXPECT_EQ(row["sequence"], "closet");
    EXPECT_EQ(row["found"], record.found);
    ASSERT_TRUE(record.object_error_mean_m && row["average [m]"].is_number()) << row;
    EXPECT_NEAR(row["average [m]"], *record.object_error_mean_m, 5.1e-5);
    EXPECT_GT(*record.object_error_mean_m, 0.0);
    EXPECT_LT(*record.object_error_mean_m, 0.2);  // of both objects; 0.10 and 0.13 are reached
    EXPECT_LT(row["cameras [m]"], 0.3);
    ++compared;
  }
  EXPECT_EQ(compared, 2);
}

TEST_F(ReproduceSmallScene, MakesNothingTwice) {
  folder_.Write("results/den-only.partial/runs/objects/other/summary.json", "{\"complete\": true}");
  Reproduce({"--only", "objects"});
  EXPECT_FALSE(fs::exists(folder_ / "results/latest/runs/objects/other")) << "of another matrix";
  EXPECT_TRUE(fs::exists(folder_ / "results/den-only")) << "not in the place of the whole";
  const std::string before = InResults("runs/objects/den/timings.csv");
  const ProgramResult again = Reproduce({"--only", "objects", "--json"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(InResults("runs/objects/den/timings.csv"), before);
  EXPECT_EQ(json::parse(InResults("environment.json"))["jobs"], (json{{"reused", 3}}));
  EXPECT_EQ(json::parse(again.out)[0]["table"], "matrix");
}

// Two rooms with objects in their maps.
class ReproduceTwoRooms : public ::testing::Test {
 protected:
  ReproduceTwoRooms() {
    for (const char* name : {"den", "lair"}) {
      std::string scene = std::regex_replace(testing::kSmallScene, std::regex("frames: 4"), "frames: 12");
      scene = std::regex_replace(scene, std::regex("name: den"), std::string("name: ") + name);
      const std::string file = folder_.Write(std::string(name) + ".yaml", scene);
      testing::RunOk({"generate", "--scene", file, "--without-cad", "--out", folder_ / "out"});
    }
  }
  ProgramResult Reproduce(const std::vector<std::string>& more) const {
    const std::string config = folder_.Write(
        "two.yaml",
        "sequences: [out/den, out/lair]\nvariants: [{name: default}, {name: fast, preset: fast}]\n");
    std::vector<std::string> arguments{"reproduce", "--config", config, "--out", folder_ / "results"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
  }

  const testing::StartedAnew anew_;
  TempFolder folder_;
};

TEST_F(ReproduceTwoRooms, ComparesVariantsOverRoomsAndTellsWhatRepeatsScatterBy) {
  const ProgramResult result = Reproduce({"--name", "one", "--jitter", "1", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  std::map<std::string, json> tables;
  for (const json& table : json::parse(result.out)) tables[table["table"]] = table["rows"];
  ASSERT_EQ(tables["rooms"].size(), 2u);
  EXPECT_EQ(tables["rooms"][0]["variant"], "default");
  EXPECT_EQ(tables["rooms"][0]["rooms"], 2) << "without the repeats";
  EXPECT_EQ(tables["rooms"][0]["found [%]"], "100 [100, 100]") << "in both rooms alike";
  EXPECT_EQ(tables["room_differences"][0]["B is"], "too few");
  EXPECT_EQ(tables["stability"][0]["runs a room"], 2);
  EXPECT_EQ(tables["worst_rooms"].size(), 2u);
  const std::string raw = ReadFile(folder_ / "results/one/evaluation/rooms/room_objects.csv");
  EXPECT_EQ(std::count(raw.begin(), raw.end(), '\n'), 1 + 2 * 2 * 2 * 2)
      << "rooms, objects, variants, repeats";
  EXPECT_NE(ReadFile(folder_ / "results/one/report.html").find("quartiles"), std::string::npos);

  fs::copy(folder_ / "results/one", folder_ / "results/two", fs::copy_options::recursive);
  const json compared = json::parse(
      testing::RunOk({"compare", folder_ / "results/one", folder_ / "results/two", "--json"}).out);
  ASSERT_EQ(compared.size(), 2u) << "a variant each";
  for (const json& row : compared[0]["rows"]) EXPECT_EQ(row["B - A"], 0) << row;
  ExpectBadInput({"compare", folder_ / "results/one", folder_ / "results/one/runs/fast"},
                 {"armature reproduce", "runs/"});
}

TEST_F(ReproduceSmallScene, RoomArgumentsThatDoNotFitAreRefused) {
  const std::string recipe = folder_.Write("recipe.yaml", "name: mixed\n");
  const std::vector<std::string> call{"reproduce", "--config", config_, "--out", folder_ / "results"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), call.begin(), call.end());
    return more;
  };
  ExpectBadInput(with({"--count", "3"}), {"--count", "--rooms"});
  ExpectBadInput(with({"--rooms", recipe, folder_ / "out/den"}), {"--rooms", "exclude"});
  ExpectBadInput(with({"--rooms", folder_ / "absent.yaml"}), {"absent.yaml"});
  ExpectBadInput(with({"--rooms", recipe, "--split", "chekc"}), {"--split", "check"});
  ExpectBadInput(with({"--rooms", recipe, "--variants", "no_flor"}), {"--variants", "no_floor"});
}

TEST_F(ReproduceSmallScene, BadInputIsOneLineAndHarmsNothing) {
  const std::vector<std::string> call{"reproduce", "--config", config_, "--out", folder_ / "results"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), call.begin(), call.end());
    return more;
  };
  ExpectBadInput(with({"--only", "den2"}), {"'den2'", "den"});
  ExpectBadInput(with({"--fast"}), {"fast", "--fast"});
  ExpectBadInput(with({"--name", "a/b"}), {"--name", "a/b"});
  folder_.Write("results/den/mine.txt", "mine");
  ExpectBadInput(call, {"results/den", "is not a folder of results of 'armature reproduce'"});
  EXPECT_EQ(ReadFile(folder_ / "results/den/mine.txt"), "mine");
}

}  // namespace
}  // namespace armature
