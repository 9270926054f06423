// SPDX-License-Identifier: BSD-3-Clause
// The trajectory table of `armature eval` as its users start it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/rotation.h"
#include "io/trajectory.h"
#include "support/program.h"
#include "support/shared_data.h"
#include "support/true_world.h"

namespace armature {
namespace {

using nlohmann::json;
using testing::ExpectBadInput;
using testing::RunOk;
using testing::TempFolder;

std::vector<TimedPose> Curve() {
  std::vector<TimedPose> poses;
  for (int i = 0; i < 30; ++i) {
    const double t = 0.1 * i;
    TimedPose pose{.timestamp = t};
    pose.pose.translation() << std::cos(t), 2 * std::sin(t), t * t;
    pose.pose.linear() = ExpSO3({0.3 * t, std::sin(t), -t});
    poses.push_back(pose);
  }
  return poses;
}

// In another frame, lengths divided by the scale.
std::vector<TimedPose> Elsewhere(std::vector<TimedPose> poses, double scale) {
  for (TimedPose& pose : poses) {
    pose.pose.translation() /= scale;
    pose.pose = Eigen::Translation3d(1, 2, 3) * Eigen::Isometry3d(ExpSO3({1, 2, 0.5})) * pose.pose;
  }
  return poses;
}

// A sequence's camera truth, without objects, and a run whose trajectory is right and whose odometry has half
// the size.
struct Desk {
  Desk() {
    folder.Write("sequence/sequence.yaml",
                 "name: desk\nfps: 10\ncamera:\n  model: pinhole\n  width: 64\n  height: 48\n  fx: 60\n"
                 "  fy: 60\n  cx: 32\n  cy: 24\n  distortion: [0, 0, 0, 0, 0]\n");
    WriteTumTrajectory(folder / "sequence/groundtruth.txt", Curve());
    folder.Write("run/summary.json", "{\"sequence\": \"desk\", \"complete\": true}\n");
    WriteTumTrajectory(folder / "run/trajectory.txt", Elsewhere(Curve(), 1));
    WriteTumTrajectory(folder / "run/odometry_scaled.txt", Elsewhere(Curve(), 2));
  }
  json Tables(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"eval", folder / "run", "--groundtruth", folder / "sequence",
                                          "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(RunOk(arguments).out);
  }
  TempFolder folder;
};

TEST(EvalTrajectories, OfARunWithoutObjectTruth) {
  const json tables = Desk().Tables({});
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0]["title"], "desk: camera trajectories");
  const json& rows = tables[0]["rows"];
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0]["run"], "run");
  EXPECT_EQ(rows[0]["trajectory"], "trajectory");
  EXPECT_EQ(rows[0]["alignment"], "first_pose");
  EXPECT_EQ(rows[1]["alignment"], "se3");
  EXPECT_EQ(rows[1]["matched"], 30);
  EXPECT_LT(rows[1]["ATE max [m]"], 1e-8);
  EXPECT_LT(rows[1]["RPE rmse [deg]"], 1e-6);
  EXPECT_NEAR(rows[1]["rotation [deg]"], Eigen::Vector3d(1, 2, 0.5).norm() / kDegree, 1e-6);
  EXPECT_EQ(rows[4]["trajectory"], "odometry_scaled");
  EXPECT_GT(rows[4]["ATE rmse [m]"], 0.1);
  EXPECT_EQ(rows[5]["alignment"], "sim3");
  EXPECT_NEAR(rows[5]["scale"], 2, 1e-7);
  EXPECT_LT(rows[5]["ATE rmse [m]"], 1e-7);
}

TEST(EvalTrajectories, WithTheAlignmentsAskedFor) {
  const Desk desk;
  const json tables =
      desk.Tables({"--alignment", "first_pose,first_n", "--alignment", "end_points", "--first-n", "5",
                   "--rpe-delta", "2f", "--raw-trajectory", desk.folder / "raw.csv"});
  const json& rows = tables[0]["rows"];
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0]["alignment"], "first_pose");
  EXPECT_EQ(rows[4]["alignment"], "first_n");
  EXPECT_NEAR(rows[5]["scale"], 2, 1e-7);
  EXPECT_EQ(rows[5]["RPE pairs"], 28);
  const std::string raw = testing::ReadFile(desk.folder / "raw.csv");
  EXPECT_EQ(std::count(raw.begin(), raw.end(), '\n'), 1 + 6 * 30);
}

TEST(EvalTrajectories, StandBesideTheObservations) {
  const testing::TrueWorld world;
  const auto run = world.WriteRun("run", testing::Unchanged, testing::SameName);
  std::filesystem::copy_file(world.folder / "sequence/groundtruth.txt", run / "trajectory.txt");
  std::filesystem::copy_file(world.folder / "sequence/groundtruth.txt", run / "odometry_scaled.txt");
  const auto tables = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"eval", run, "--groundtruth", world.folder / "sequence", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(RunOk(arguments).out);
  };
  const json all = tables({});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_LT(all[2]["rows"][0]["ATE max [m]"], 1e-12);
  EXPECT_EQ(tables({"--tables", "trajectory"}).size(), 1u);
  EXPECT_EQ(tables({"--tables", "observations"}).size(), 2u);
  EXPECT_EQ(tables({"--tables", "observations,trajectory"}).size(), 3u);
}

TEST(EvalTrajectories, OfARunWithoutOdometryAreEmpty) {
  const Desk desk;
  WriteTumTrajectory(desk.folder / "run/trajectory.txt", {});
  const json row = desk.Tables({})[0]["rows"][0];
  EXPECT_EQ(row["matched"], 0);
  EXPECT_EQ(row["poses"], 0);
  EXPECT_EQ(row["ATE rmse [m]"], nullptr);
  EXPECT_EQ(row["scale"], nullptr);
}

TEST(EvalTrajectories, NeedNoOdometry) {
  const Desk desk;
  std::filesystem::remove(desk.folder / "run/odometry_scaled.txt");
  EXPECT_EQ(desk.Tables({})[0]["rows"].size(), 3u);
}

TEST(EvalTrajectories, OfFilesInAnyFormat) {
  const TempFolder folder;
  const auto kitti = folder.Write("k.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 3 0 1 0 4 0 0 1 0\n");
  const auto euroc = folder.Write("e.csv", "#t,p,q\n0,0,0,0,1,0,0,0\n500000000,3,4.5,0,1,0,0,0\n");
  const auto times = folder.Write("times.txt", "0\n0.5\n");
  for (const auto& arguments : {std::vector<std::string>{"--stamps", times}, {"--fps", "2"}}) {
    std::vector<std::string> command = {"eval",        euroc,        "--groundtruth", kitti,
                                        "--alignment", "first_pose", "--json"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const json row = json::parse(RunOk(command).out)[0]["rows"][0];
    EXPECT_EQ(row["run"], "e.csv");
    EXPECT_EQ(row["matched"], 2);
    EXPECT_NEAR(row["ATE max [m]"], 0.5, 1e-12);
  }
}

// Moved in time: rows of dashes alone would be taken for a result.
TEST(EvalTrajectories, WithoutAnyPairFailAndSayWhatMayBeWrong) {
  const TempFolder folder;
  WriteTumTrajectory(folder / "truth.txt", Curve());
  auto later = Elsewhere(Curve(), 1), nanoseconds = Elsewhere(Curve(), 1);
  for (TimedPose& pose : later) pose.timestamp += 100;
  for (TimedPose& pose : nanoseconds) pose.timestamp = 1e9 * (pose.timestamp + 0.05);
  WriteTumTrajectory(folder / "later.txt", later);
  WriteTumTrajectory(folder / "ns.txt", nanoseconds);
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"eval", "--groundtruth", folder / "truth.txt", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return testing::RunProgram(arguments);
  };
  const auto shifted = run({folder / "later.txt"});
  EXPECT_EQ(shifted.status, 1);
  EXPECT_NE(shifted.err.find("armature: later.txt: no pose has a true one within 10 ms"), std::string::npos);
  EXPECT_NE(shifted.err.find("--time-offset -100 "), std::string::npos) << shifted.err;
  EXPECT_EQ(json::parse(shifted.out)[0]["rows"][0]["ATE rmse [m]"], nullptr);
  const auto units = run({folder / "ns.txt", folder / "truth.txt"});
  EXPECT_EQ(units.status, 1);
  EXPECT_NE(units.err.find("nanoseconds?"), std::string::npos) << units.err;
  EXPECT_EQ(json::parse(units.out)[0]["rows"][3]["matched"], 30);
  const auto offset = run({folder / "later.txt", "--time-offset", "-100"});
  EXPECT_EQ(offset.status, 0) << offset.err;
  EXPECT_EQ(json::parse(offset.out)[0]["rows"][0]["matched"], 30);
  const Desk desk;
  ExpectBadInput(
      {"eval", desk.folder / "run", "--groundtruth", desk.folder / "sequence", "--time-offset", "1"},
      {"--time-offset", "trajectory files"});
}

TEST(EvalTrajectories, OfKittiFilesOfUnequalLengthAreRefused) {
  const TempFolder folder;
  const std::string line = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  const auto two = folder.Write("two.txt", line + line),
             three = folder.Write("three.txt", line + line + line);
  ExpectBadInput({"eval", two, "--groundtruth", three}, {"two.txt: has 2 poses", "three.txt has 3"});
  EXPECT_EQ(testing::RunProgram({"eval", two, "--groundtruth", two}).status, 0);
}

TEST(EvalTrajectories, WithRepeatedStampsKeepTheFirstAndSayHowMany) {
  const TempFolder folder;
  WriteTumTrajectory(folder / "truth.txt", Curve());
  auto repeated = Curve();
  repeated.insert(repeated.begin() + 5, repeated[4]);
  repeated[5].pose.translation().x() += 1;
  WriteTumTrajectory(folder / "e.txt", repeated);
  const auto result = RunOk(
      {"eval", folder / "e.txt", "--groundtruth", folder / "truth.txt", "--alignment", "none", "--json"});
  EXPECT_NE(result.err.find("e.txt: 1 of 31 poses"), std::string::npos) << result.err;
  EXPECT_LT(json::parse(result.out)[0]["rows"][0]["ATE max [m]"], 1e-8);
}

TEST(EvalTrajectories, BadInput) {
  const Desk desk;
  const std::string run = desk.folder / "run", truth = desk.folder / "sequence";
  const std::string file = desk.folder / "run/trajectory.txt";
  ExpectBadInput({"eval", run}, {"'desk'", "--groundtruth"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--alignment", "sim2"}, {"'sim2'", "'sim3'"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--tables", "trajectories"}, {"'trajectory'"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--tables", "observations"}, {"observations.csv"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--first-n", "0"}, {"--first-n 0"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--tolerance", "-1"}, {"--tolerance -1"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--rpe-delta", "1 mile"}, {"'1 mile'", "0.5m"});
  ExpectBadInput({"eval", run, "--groundtruth", truth, "--raw-trajectory", run + "/summary.json/raw.csv"},
                 {"raw.csv", "cannot be written"});
  ExpectBadInput({"eval", file}, {"--groundtruth", "one true trajectory"});
  ExpectBadInput({"eval", file, "--groundtruth", file, "--trajectory-format", "kitti"},
                 {"trajectory.txt:2", "KITTI", "12"});
  ExpectBadInput({"eval", file, "--groundtruth", file, "--raw", desk.folder / "raw.csv"},
                 {"--raw-trajectory"});
  ExpectBadInput({"eval", file, "--groundtruth", file, "--tables", "observations"}, {"'trajectory'"});
  ExpectBadInput({"eval", file, "--groundtruth", desk.folder / "nowhere.txt"}, {"nowhere.txt", "opened"});
  desk.folder.Write("run/odometry_scaled.txt", "0 0 0 0 0 0 0 2\n");
  ExpectBadInput({"eval", run, "--groundtruth", truth}, {"odometry_scaled.txt:1", "length 2"});
  std::filesystem::remove(desk.folder / "sequence/groundtruth.txt");
  ExpectBadInput({"eval", run, "--groundtruth", truth}, {"groundtruth.txt", "objects_gt.csv"});
}

TEST(EvalTrajectoriesOnRealData, PrintsTheReferenceValues) {
  ARMATURE_SHARED_DATA_OR_SKIP(folder, "trajectories");
  const auto result = RunOk({"eval", folder / "freiburg1_xyz-rgbdslam.txt", "--groundtruth",
                             folder / "freiburg1_xyz-groundtruth.txt", "--alignment", "se3", "--alignment",
                             "sim3", "--json"});
  const json rows = json::parse(result.out)[0]["rows"];
  EXPECT_EQ(rows[0]["matched"], 785);
  EXPECT_EQ(rows[0]["poses"], 788);
  EXPECT_NEAR(rows[0]["ATE rmse [m]"], 0.013470088849733696, 1e-9);
  EXPECT_NEAR(rows[1]["ATE rmse [m]"], 0.013389384904168208, 1e-9);
  EXPECT_NEAR(rows[1]["scale"], 1.0080013899313371, 1e-9);
}

}  // namespace
}  // namespace armature
