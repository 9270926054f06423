// SPDX-License-Identifier: BSD-3-Clause
// `armature run` from end to end, on the built-in sample and on tiny sequences.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"
#include "io/csv.h"
#include "support/small_scene.h"
#include "support/tiny_sequence.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::GenerateSmallScene;
using testing::ProgramResult;
using testing::ReadFile;
using testing::RunOk;
using testing::TempFolder;
using testing::WriteTinySequence;
using Files = std::set<std::string>;

const Files kRunFiles = {
    "associations.csv",    "config.yaml",        "objects.csv",  "objects_odometry.csv", "observations.csv",
    "odometry_scaled.txt", "shape_evidence.csv", "summary.json", "timings.csv",          "trajectory.txt"};

struct Errors {
  std::vector<double> azimuth_deg, translation_percent;
};

double Middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.at(values.size() / 2);
}

Eigen::Isometry3d PoseOf(const CsvRow& row) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << row.Number("tx"), row.Number("ty"), row.Number("tz");
  pose.linear() = Eigen::Quaterniond(row.Number("qw"), row.Number("qx"), row.Number("qy"), row.Number("qz"))
                      .toRotationMatrix();
  return pose;
}

double Azimuth(const Eigen::Isometry3d& T_camera_object) {
  return ViewpointFromRotation(T_camera_object.linear(), T_camera_object.translation()).azimuth;
}

// Of the placed objects, by category. Tables look the same when turned by half a turn.
std::map<std::string, Errors> ErrorsOf(const std::filesystem::path& run,
                                       const std::filesystem::path& sequence) {
  const GroundTruth truth = LoadGroundTruth(sequence);
  std::map<std::string, Errors> errors;
  const CsvTable table(run / "observations.csv", {"timestamp", "index", "status"});
  for (const CsvRow& row : table.rows()) {
    if (row.Text("status") != "ok") continue;
    const double timestamp = row.Number("timestamp");
    const Eigen::Isometry3d T_true = truth.TrueCameraObject(timestamp, row.Integer("index")).value();
    const std::string category = truth.FindObject(timestamp, row.Integer("index"))->category;
    const Eigen::Isometry3d T = PoseOf(row);
    const int order = category == "table" ? 2 : 1;
    Errors& e = errors[category];
    e.azimuth_deg.push_back(std::abs(AzimuthDifference(Azimuth(T), Azimuth(T_true), order)) / kDegree);
    e.translation_percent.push_back(100 * (T.translation() - T_true.translation()).norm() /
                                    T_true.translation().norm());
  }
  return errors;
}

TEST(AppRun, FindsTheFurnitureOfTheSample) {
  const TempFolder folder;
  const std::string sequence = folder / "sample", run = folder / "run";
  RunOk({"generate", "--only", "sample", "--without-cad", "--frames", "6", "--out", folder.path()});
  const ProgramResult result = RunOk({"run", sequence, "--out", run});
  EXPECT_EQ(AllFiles(run), kRunFiles);
  EXPECT_NE(result.out.find(run), std::string::npos) << result.out;
  for (const std::string& file : kRunFiles) EXPECT_NE(result.out.find(file), std::string::npos) << file;

  const auto summary = nlohmann::json::parse(ReadFile(folder / "run/summary.json"));
  EXPECT_EQ(summary["sequence"], "sample");
  EXPECT_EQ(summary["counts"]["frames"], 6);
  EXPECT_GT(summary["stages_ms"]["load"]["median"], 0);

  const std::map<std::string, Errors> errors = ErrorsOf(run, sequence);
  for (const auto& [category, least] : {std::pair{"chair", 13u}, {"table", 5u}, {"laptop", 5u}}) {
    const Errors& e = errors.at(category);
    EXPECT_GE(e.azimuth_deg.size(), least) << category;
    EXPECT_LT(Middle(e.azimuth_deg), 10) << category;
    EXPECT_LT(Middle(e.translation_percent), 15) << category;
  }
}

TEST(AppRun, SameInputGivesTheSameBytes) {
  const TempFolder folder;
  const std::string sequence = folder / "out/den";
  GenerateSmallScene(folder, 4);
  RunOk({"run", sequence, "--out", folder / "a"});
  RunOk({"run", sequence, "--out", folder / "b"});
  RunOk({"run", sequence, "--out", folder / "b"});  // a finished run may be replaced
  for (const std::string file : {"observations.csv", "associations.csv", "config.yaml", "trajectory.txt"}) {
    EXPECT_EQ(ReadFile(folder / "a" / file), ReadFile(folder / "b" / file)) << file;
  }
  EXPECT_GT(CsvTable(folder / "a/associations.csv", {"timestamp"}).rows().size(), 20u);
}

TEST(AppRun, TwoThreadsGiveTheSameBytesAndSkipTheSameImages) {
  const TempFolder folder;
  const std::string sequence = folder / "out/den";
  GenerateSmallScene(folder, 4);
  std::ofstream(sequence + "/rgb/0002.jpg") << "not an image";
  RunOk({"run", sequence, "--out", folder / "one"});
  RunOk({"run", sequence, "--out", folder / "two", "--pipelined"});
  for (const std::string file : {"observations.csv", "associations.csv", "objects.csv", "trajectory.txt"}) {
    EXPECT_EQ(ReadFile(folder / "one" / file), ReadFile(folder / "two" / file)) << file;
  }
  const auto summary = nlohmann::json::parse(ReadFile(folder / "two/summary.json"));
  EXPECT_EQ(summary["threads"], 2);
  EXPECT_EQ(summary["counts"]["skipped_images"], 1);
  EXPECT_GT(summary["pace"]["frames_per_second"], 0);
  EXPECT_GE(summary["pace"]["latency_ms"]["median"], summary["stages_ms"]["association"]["median"]);
}

TEST(AppRun, DrawsOverlaysOfTheFirstFrames) {
  const TempFolder folder;
  GenerateSmallScene(folder, 3);
  RunOk({"run", folder / "out/den", "--out", folder / "run", "--frames", "2", "--overlays"});
  Files expected = kRunFiles;
  expected.insert({"overlays", "overlays/000000.jpg", "overlays/000001.jpg"});
  EXPECT_EQ(AllFiles(folder / "run"), expected);
  EXPECT_EQ(cv::imread(folder / "run/overlays/000001.jpg").size(), cv::Size(160, 120));
}

TEST(AppRun, RunsSeveralSequencesIntoFoldersOfTheirNames) {
  const TempFolder one, two, out;
  WriteTinySequence(one);
  WriteTinySequence(two);
  two.Write("sequence.yaml", testing::TinySequenceYaml("other"));
  const ProgramResult result =
      RunOk({"run", one.path(), two.path(), "--out", out / "runs", "--json", "--preset", "fast"});
  EXPECT_EQ(AllFiles(out / "runs/tiny"), kRunFiles);
  EXPECT_EQ(AllFiles(out / "runs/other"), kRunFiles);
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[1]["sequence"], "other");
  EXPECT_EQ(json[1]["summary"]["preset"], "fast");
  EXPECT_EQ(json[0]["summary"]["counts"]["detections"], 2);
}

TEST(AppRun, SkipsAnUnreadableImageInTheMiddle) {
  const TempFolder folder;
  WriteTinySequence(folder);
  folder.Write("rgb/broken.png", "not an image");
  folder.Write("rgb.txt", "0.0 rgb/0.png\n0.1 rgb/broken.png\n0.2 rgb/1.png\n");
  const ProgramResult result = RunOk({"run", folder.path(), "--out", folder / "run", "--overlays"});
  EXPECT_NE(result.err.find("rgb/broken.png"), std::string::npos) << result.err;
  const auto summary = nlohmann::json::parse(ReadFile(folder / "run/summary.json"));
  EXPECT_EQ(summary["counts"]["skipped_images"], 1);
  EXPECT_EQ(summary["counts"]["frames"], 2);
  EXPECT_EQ(CsvTable(folder / "run/timings.csv", {"timestamp"}).rows().size(), 2u);
  EXPECT_EQ(AllFiles(folder / "run/overlays"), (Files{"000000.jpg", "000002.jpg"}));
}

TEST(AppRun, RunsWithoutOdometryAndDetections) {
  const TempFolder folder;
  WriteTinySequence(folder);
  folder.Write("detections.csv", testing::kTinyDetectionsHeader);
  std::filesystem::remove(folder / "odometry.txt");
  RunOk({"run", folder.path(), "--out", folder / "run"});
  EXPECT_EQ(CsvTable(folder / "run/timings.csv", {"timestamp"}).rows().size(), 2u);
}

TEST(AppRun, TheConfigurationOfARunRepeatsIt) {
  const TempFolder folder;
  WriteTinySequence(folder);
  RunOk({"run", folder.path(), "--out", folder / "a", "--preset", "paper", "--set", "lines.min_length=12.5"});
  const std::string config = ReadFile(folder / "a/config.yaml");
  EXPECT_NE(config.find("cost: printed"), std::string::npos) << config;
  EXPECT_NE(config.find("min_length: 12.5"), std::string::npos) << config;
  RunOk({"run", folder.path(), "--out", folder / "b", "--config", folder / "a/config.yaml"});
  const std::string again = ReadFile(folder / "b/config.yaml");
  EXPECT_EQ(config.substr(config.find('\n')), again.substr(again.find('\n')));
}

}  // namespace
}  // namespace armature
