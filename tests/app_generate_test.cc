// SPDX-License-Identifier: BSD-3-Clause
// `armature generate`, as its users start it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "datasets/cad/cad_instance.h"
#include "eval/ground_truth.h"
#include "geometry/rotation.h"
#include "io/csv.h"
#include "io/sequence.h"
#include "support/expect_input_error.h"
#include "support/program.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::ExpectBadInput;
using testing::ProgramResult;
using testing::ReadFile;
using testing::RunOk;
using testing::TempFolder;

// The first frames of the smallest shipped scene, into FOLDER/sample.
ProgramResult Generate(const TempFolder& folder, int frames) {
  return RunOk({"generate", "--only", "sample", "--without-cad", "--frames", std::to_string(frames), "--out",
                folder.path()});
}

TEST(AppGenerate, WritesASequenceWithItsTruth) {
  const TempFolder folder;
  Generate(folder, 2);
  EXPECT_EQ(AllFiles(folder / "sample"),
            (std::set<std::string>{"detections.csv", "detections_gt.csv", "edges_gt.csv", "generated.json",
                                   "groundtruth.txt", "objects_gt.csv", "odometry.txt", "rgb", "rgb.txt",
                                   "rgb/0000.jpg", "rgb/0001.jpg", "scene.yaml", "sequence.yaml"}));
  const Sequence sequence = LoadSequence(folder / "sample", {"chair", "table", "laptop"});
  EXPECT_EQ(sequence.images.size(), 2U);
  EXPECT_FALSE(sequence.odometry_metric);
  for (const auto& pose : sequence.T_odom_camera) EXPECT_TRUE(pose);
  EXPECT_EQ(cv::imread(sequence.images.front().file.string()).size(), cv::Size(640, 480));
  const GroundTruth truth = LoadGroundTruth(folder / "sample");
  EXPECT_EQ(truth.T_world_camera.size(), 2U);
  EXPECT_EQ(truth.objects.size(), 5U);
  EXPECT_GT(cv::imread(folder / "contact_sheet.jpg").cols, 0);
}

// The corners of every object's bounding box project around its detection, and up is up.
TEST(AppGenerate, DetectionsAreWhereTheObjectsAre) {
  const TempFolder folder;
  Generate(folder, 1);
  const Sequence sequence = LoadSequence(folder / "sample", {"chair", "table", "laptop"});
  const GroundTruth truth = LoadGroundTruth(folder / "sample");
  int compared = 0;
  for (size_t i = 0; i < sequence.detections[0].size(); ++i) {
    const TrueObject* object = truth.ObjectOf(0, static_cast<int>(i));
    if (!object) continue;  // a false alarm
    const Box& box = sequence.detections[0][i].box;
    EXPECT_EQ(object->category, sequence.detections[0][i].category);
    const Eigen::Isometry3d T_camera_object = *truth.TrueCameraObject(0, static_cast<int>(i));
    Eigen::AlignedBox2d corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      corners.extend(sequence.camera.Project(T_camera_object * object->size.cwiseProduct(sign)));
    }
    const Box around =
        Box{corners.min().x(), corners.min().y(), corners.sizes().x(), corners.sizes().y()}.Grown(15);
    EXPECT_NEAR(Intersection(around, box).area(), box.area(), 1) << object->id;
    ++compared;
  }
  EXPECT_GE(compared, 3);
  // The odometry's frame is the first camera's.
  ASSERT_TRUE(sequence.up);
  const Eigen::Matrix3d R_camera_world = truth.T_world_camera.front().pose.linear().transpose();
  EXPECT_LT((*sequence.up - R_camera_world * Eigen::Vector3d::UnitZ()).norm(), 1e-5);
}

TEST(AppGenerate, EdgesAreThoseOfTheCategoriesAndMostlySeen) {
  const TempFolder folder;
  Generate(folder, 1);
  const CsvTable table(folder / "sample/edges_gt.csv",
                       {"timestamp", "id", "edge", "x1", "y1", "x2", "y2", "visible"});
  const GroundTruth truth = LoadGroundTruth(folder / "sample");
  ASSERT_GT(table.rows().size(), 20U);
  double seen = 0;
  for (const CsvRow& row : table.rows()) {
    const auto object = std::find_if(truth.objects.begin(), truth.objects.end(),
                                     [&](const TrueObject& o) { return o.id == row.Text("id"); });
    ASSERT_NE(object, truth.objects.end());
    const std::vector<std::string> names = EdgeNames(object->category);
    EXPECT_NE(std::find(names.begin(), names.end(), row.Text("edge")), names.end()) << row.Text("edge");
    EXPECT_GE(row.Number("x1"), -0.5);
    EXPECT_LE(row.Number("x2"), 639.5);
    EXPECT_GE(row.Number("visible"), 0);
    EXPECT_LE(row.Number("visible"), 1);
    seen += row.Number("visible") / static_cast<double>(table.rows().size());
  }
  EXPECT_GT(seen, 0.4);
  EXPECT_LT(seen, 0.98);
}

TEST(AppGenerate, IsDoneOnceAndReused) {
  const TempFolder folder;
  Generate(folder, 1);
  const auto written = std::filesystem::last_write_time(folder / "sample/rgb/0000.jpg");
  EXPECT_NE(Generate(folder, 1).out.find("there already"), std::string::npos);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "sample/rgb/0000.jpg"), written);
  EXPECT_EQ(Generate(folder, 2).out.find("there already"), std::string::npos);  // another one replaces it
  EXPECT_TRUE(std::filesystem::exists(folder / "sample/rgb/0001.jpg"));
}

TEST(AppGenerate, GivesTheSameBytesWhateverTheThreads) {
  const TempFolder one, two;
  setenv("OMP_NUM_THREADS", "1", 1);
  Generate(one, 3);
  setenv("OMP_NUM_THREADS", "2", 1);
  Generate(two, 3);
  unsetenv("OMP_NUM_THREADS");
  for (const std::string& file : AllFiles(one / "sample")) {
    if (file == "rgb") continue;
    EXPECT_EQ(ReadFile(one / "sample" / file), ReadFile(two / "sample" / file)) << file;
  }
}

TEST(AppGenerate, ShorterRunsAreTheStartOfLongerOnes) {
  const TempFolder one, two;
  Generate(one, 1);
  Generate(two, 2);
  EXPECT_EQ(ReadFile(one / "sample/rgb/0000.jpg"), ReadFile(two / "sample/rgb/0000.jpg"));
  for (const std::string file : {"detections.csv", "odometry.txt", "groundtruth.txt", "edges_gt.csv"})
    EXPECT_TRUE(ReadFile(two / "sample" / file).starts_with(ReadFile(one / "sample" / file))) << file;
}

TEST(AppGenerate, NoiseChangesDetectionsAlone) {
  const TempFolder one, two;
  Generate(one, 1);
  RunOk({"generate", "--only", "sample", "--without-cad", "--frames", "1", "--detection-noise", "2", "--out",
         two.path()});
  EXPECT_NE(ReadFile(one / "sample/detections.csv"), ReadFile(two / "sample/detections.csv"));
  EXPECT_EQ(ReadFile(one / "sample/rgb/0000.jpg"), ReadFile(two / "sample/rgb/0000.jpg"));
  EXPECT_EQ(ReadFile(one / "sample/odometry.txt"), ReadFile(two / "sample/odometry.txt"));
}

TEST(AppGenerate, WritesAnnotatedModelsBesideTheSequences) {
  const TempFolder folder;
  RunOk({"generate", "--only", "sample", "--frames", "1", "--out", folder.path()});
  EXPECT_TRUE(std::filesystem::exists(folder / "cad/instances.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "cad/chair_edges.csv"));
}

TEST(AppGenerate, RendersAScenesFileOfTheUser) {
  const TempFolder folder;
  std::string scene = ReadFile(std::string(ARMATURE_SOURCE_DIR) + "/datasets/scenes/sample.yaml");
  scene.replace(scene.find("name: sample"), 12, "name: mine");
  folder.Write("my.yaml", scene);
  RunOk(
      {"generate", "--scene", folder / "my.yaml", "--without-cad", "--frames", "1", "--out", folder / "out"});
  EXPECT_TRUE(std::filesystem::exists(folder / "out/mine/rgb/0000.jpg"));
}

TEST(AppGenerate, DoesNotReplaceWhatSomebodyElseMade) {
  const TempFolder folder;
  folder.Write("sample/notes.txt", "precious");
  ExpectBadInput({"generate", "--only", "sample", "--without-cad", "--frames", "1", "--out", folder.path()},
                 {"sample", "exists", "generate"});
  EXPECT_EQ(AllFiles(folder.path()), (std::set<std::string>{"sample", "sample/notes.txt"}));
}

TEST(AppGenerate, BadArgumentsAreOneLine) {
  const TempFolder folder;
  ExpectBadInput({"generate", "--only", "seq7", "--out", folder.path()}, {"--only", "seq7", "seq1"});
  ExpectBadInput({"generate", "--only", "seq1", "--scene", "x.yaml", "--out", folder.path()},
                 {"--only", "--scene"});
  ExpectBadInput({"generate", "--frames", "0", "--out", folder.path()}, {"--frames"});
  ExpectBadInput({"generate", "--detection-noise", "-1", "--out", folder.path()}, {"--detection-noise"});
  ExpectBadInput({"generate", "--scene", folder / "none.yaml", "--out", folder.path()}, {"none.yaml"});
  EXPECT_TRUE(AllFiles(folder.path()).empty());
}

}  // namespace
}  // namespace armature
