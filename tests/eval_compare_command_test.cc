// SPDX-License-Identifier: BSD-3-Clause
// `armature compare` as its users start it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geometry/rotation.h"
#include "io/trajectory.h"
#include "support/program.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::ProgramResult;
using testing::ReadFile;
using testing::RunOk;
using Json = nlohmann::json;

constexpr int kFrames = 20;

// Runs on one sequence with a true camera path. `aside`: by which cameras after the first are off, in turns
// above and below; `ms`: time of each frame.
class Compare : public ::testing::Test {
 protected:
  Compare() {
    WriteSequence("sequence", "desk");
    WriteTumTrajectory(folder_ / "sequence/groundtruth.txt", Path(0));
    WriteRun("a", "desk", 0.1, 5);
  }

  static std::vector<TimedPose> Path(double aside) {
    std::vector<TimedPose> poses;
    for (int i = 0; i < kFrames; ++i) {
      TimedPose pose{.timestamp = 0.1 * i};
      pose.pose.translation() << 0.2 * i, i == 0 ? 0 : aside + 0.1 * aside * (i % 2 ? 1 : -1), 0;
      poses.push_back(pose);
    }
    return poses;
  }

  void WriteSequence(const std::string& name, const std::string& sequence) const {
    folder_.Write(name + "/sequence.yaml",
                  "name: " + sequence +
                      "\nfps: 10\ncamera: {model: pinhole, width: 64, height: 48, fx: 60, "
                      "fy: 60, cx: 32, cy: 24, distortion: [0, 0, 0, 0, 0]}\n");
    folder_.Write(name + "/detections.csv", "of " + name + "\n");
  }

  void WriteRun(const std::string& name, const std::string& sequence, double aside, double ms,
                const std::string& data = "sequence") const {
    const nlohmann::json summary{
        {"sequence", sequence}, {"sequence_folder", folder_ / data}, {"complete", true}};
    folder_.Write(name + "/summary.json", summary.dump());
    WriteTumTrajectory(folder_ / (name + "/trajectory.txt"), Path(aside));
    std::string times = "timestamp,lines_ms,total_ms\n";
    for (int i = 0; i < kFrames; ++i) times += std::to_string(0.1 * i) + ",2," + std::to_string(ms) + "\n";
    folder_.Write(name + "/timings.csv", times);
  }

  Json Tables(const std::string& b, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"compare", folder_ / "a", folder_ / b, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(RunOk(arguments).out);
  }

  testing::TempFolder folder_;
};

TEST_F(Compare, ARunWithItselfFindsNothing) {
  const Json rows = Tables("a").at(0)["rows"];
  ASSERT_EQ(rows.size(), 3u);
  for (const Json& row : rows) {
    EXPECT_EQ(row["B - A"], 0);
    EXPECT_EQ(row["B is"], "same");
    EXPECT_EQ(row["pairs"], kFrames);
  }
}

TEST_F(Compare, MarksAKnownShift) {
  WriteRun("b", "desk", 0.3, 4);
  const Json rows = Tables("b", {"--raw", folder_ / "raw.csv"}).at(0)["rows"];
  EXPECT_EQ(rows[0]["quantity"], "camera position error [m]");
  EXPECT_NEAR(rows[0]["B - A"], 0.2, 0.03);
  EXPECT_EQ(rows[0]["B is"], "higher");
  EXPECT_EQ(rows[1]["quantity"], "time: total [ms]");
  EXPECT_EQ(rows[1]["B - A"], -1);
  EXPECT_EQ(rows[1]["B is"], "lower");
  EXPECT_EQ(rows[2]["B is"], "same");
  const std::string raw = ReadFile(folder_ / "raw.csv");
  EXPECT_EQ(std::count(raw.begin(), raw.end(), '\n'), 1 + 3 * kFrames);
}

TEST_F(Compare, EachOtherWithTheFirst) {
  WriteRun("b", "desk", 0.3, 4);
  WriteRun("c", "desk", 0.1, 9);
  const Json tables = Tables("b", {folder_ / "c"});
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[1]["rows"][1]["B - A"], 4);
}

TEST_F(Compare, WarnsOfOtherData) {
  WriteSequence("other", "desk");
  WriteRun("b", "desk", 0.1, 5, "other");
  const ProgramResult result = RunOk({"compare", folder_ / "a", folder_ / "b"});
  const std::string warning = "detections.csv of the two sequence folders differ";
  EXPECT_NE(result.err.find(warning), std::string::npos) << result.err;
  EXPECT_NE(result.out.find(warning), std::string::npos) << result.out;
}

TEST_F(Compare, RunsWithoutTruthTellsHowFarTheyAreApart) {
  std::filesystem::remove(folder_ / "sequence/groundtruth.txt");
  WriteRun("b", "desk", 0.3, 4);
  const Json tables = Tables("b");
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0]["rows"].size(), 2u);     // times
  const Json& cameras = tables[1]["rows"][0];  // they have no objects
  EXPECT_EQ(cameras["of B from A"], "camera positions [m]");
  EXPECT_NEAR(cameras["max"], 0.22, 1e-4);
}

TEST_F(Compare, RefusesWhatHasNothingInCommon) {
  ExpectBadInput({"compare", folder_ / "a"}, {"two results"});
  ExpectBadInput({"compare", folder_ / "a", folder_ / "sequence"}, {"sequence", "not a finished run"});
  WriteSequence("other", "room");
  WriteRun("b", "room", 0, 5, "other");
  ExpectBadInput({"compare", folder_ / "a", folder_ / "b"}, {"no sequence in common", "desk", "room"});
  folder_.Write("bench/bench.json", R"({"complete": true})");
  ExpectBadInput({"compare", folder_ / "a", folder_ / "bench"}, {"compare runs with runs"});
  ExpectBadInput({"compare", folder_ / "bench", folder_ / "bench"}, {"bench.json", "schema"});
}

TEST_F(Compare, RefusesTwoRunsOfOneSequence) {
  WriteRun("many/x", "desk", 0, 5);
  WriteRun("many/y", "desk", 0, 5);
  ExpectBadInput({"compare", folder_ / "a", folder_ / "many"}, {"'x' and 'y'", "desk"});
}

}  // namespace
}  // namespace armature
