// SPDX-License-Identifier: BSD-3-Clause
// `armature generate`, as its users start it. The light of a scene takes most of the time, so few scenes are
// made, small ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "datasets/cad/cad_instance.h"
#include "geometry/rotation.h"
#include "io/csv.h"
#include "io/sequence.h"
#include "support/small_scene.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::ExpectBadInput;
using testing::GenerateSmallScene;
using testing::ReadFile;
using testing::RunOk;
using testing::TempFolder;

TEST(AppGenerate, WritesASequenceWithItsTruthAndAnnotatedModels) {
  const TempFolder folder;
  folder.Write("my.yaml", testing::kSmallScene);
  RunOk({"generate", "--scene", folder / "my.yaml", "--frames", "2", "--out", folder / "new/out"});
  EXPECT_EQ(AllFiles(folder / "new/out/den"),
            (std::set<std::string>{"detections.csv", "detections_gt.csv", "edges_gt.csv", "generated.json",
                                   "groundtruth.txt", "objects_gt.csv", "odometry.txt", "rgb", "rgb.txt",
                                   "rgb/0000.jpg", "rgb/0001.jpg", "scene.yaml", "sequence.yaml"}));
  const Sequence sequence = LoadSequence(folder / "new/out/den", {"table", "laptop"});
  EXPECT_EQ(sequence.images.size(), 2U);
  EXPECT_FALSE(sequence.odometry_metric);
  for (const auto& pose : sequence.T_odom_camera) EXPECT_TRUE(pose);
  EXPECT_EQ(cv::imread(sequence.images.front().file.string()).size(), cv::Size(160, 120));
  const GroundTruth truth = LoadGroundTruth(folder / "new/out/den");
  EXPECT_EQ(truth.T_world_camera.size(), 2U);
  EXPECT_EQ(truth.objects.size(), 2U);
  EXPECT_EQ(ReadFile(folder / "new/out/den/scene.yaml"), testing::kSmallScene);
  EXPECT_GT(cv::imread(folder / "new/out/contact_sheet.jpg").cols, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "new/out/cad/instances.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "new/out/cad/chair_edges.csv"));
}

TEST(AppGenerate, LinesOnlyAreRunWithoutPictures) {
  const TempFolder folder;
  folder.Write("my.yaml", testing::kSmallScene);
  RunOk({"generate", "--scene", folder / "my.yaml", "--frames", "4", "--lines-only", "--without-cad", "--out",
         folder / "out"});
  EXPECT_FALSE(std::filesystem::exists(folder / "out/den/rgb"));
  const Sequence sequence = LoadSequence(folder / "out/den", {"table", "laptop"});
  ASSERT_EQ(sequence.segments.size(), 4u);
  for (const auto& segments : sequence.segments) EXPECT_GT(segments.size(), 10u);
  EXPECT_GT(cv::imread(folder / "out/contact_sheet.jpg").cols, 0);
  RunOk({"run", folder / "out/den", "--out", folder / "run"});
  EXPECT_NE(ReadFile(folder / "run/observations.csv").find(",ok,"), std::string::npos);
  ExpectBadInput({"run", folder / "out/den", "--out", folder / "drawn", "--overlays"}, {"no picture"});
}

// The corners of every object's bounding box project around its detection.
void ExpectDetectionsAroundTheirObjects(const Sequence& sequence, const GroundTruth& truth, size_t frame) {
  const double timestamp = sequence.images[frame].timestamp;
  const std::vector<Detection>& detections = sequence.detections[frame];
  for (size_t i = 0; i < detections.size(); ++i) {
    const TrueObject* object = truth.FindObject(timestamp, static_cast<int>(i));
    ASSERT_NE(object, nullptr);  // the scene has no false alarms
    EXPECT_EQ(object->category, detections[i].category);
    const Eigen::Isometry3d T_camera_object = *truth.TrueCameraObject(timestamp, static_cast<int>(i));
    Eigen::AlignedBox2d corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      corners.extend(sequence.camera.Project(T_camera_object * object->size.cwiseProduct(sign)));
    }
    const Box& box = detections[i].box;
    const Box around =
        Box{corners.min().x(), corners.min().y(), corners.sizes().x(), corners.sizes().y()}.Grown(8);
    EXPECT_NEAR(Intersection(around, box).area(), box.area(), 1) << object->id;
    EXPECT_GT(IntersectionOverUnion(around, box), 0.3) << object->id;
  }
}

void ExpectEdgesOfTheCategoriesMostlySeen(const CsvTable& table, const GroundTruth& truth) {
  ASSERT_GT(table.rows().size(), 20U);
  double seen = 0;
  for (const CsvRow& row : table.rows()) {
    const auto object = std::find_if(truth.objects.begin(), truth.objects.end(),
                                     [&](const TrueObject& o) { return o.id == row.Text("id"); });
    ASSERT_NE(object, truth.objects.end());
    const std::vector<std::string> names = EdgeNames(object->category);
    EXPECT_NE(std::find(names.begin(), names.end(), row.Text("edge")), names.end()) << row.Text("edge");
    for (const char* x : {"x1", "x2"}) {
      EXPECT_GE(row.Number(x), -0.5);
      EXPECT_LE(row.Number(x), 159.5);
    }
    EXPECT_GE(row.Number("visible"), 0);
    EXPECT_LE(row.Number("visible"), 1);
    seen += row.Number("visible") / static_cast<double>(table.rows().size());
  }
  EXPECT_GT(seen, 0.4);
  EXPECT_LT(seen, 0.99);  // the laptop hides a part of the table
}

TEST(AppGenerate, TheTruthIsOfWhatIsInThePictures) {
  const TempFolder folder;
  GenerateSmallScene(folder, 4);
  const auto den = folder / "out/den";
  const Sequence sequence = LoadSequence(den, {"table", "laptop"});
  const GroundTruth truth = LoadGroundTruth(den);
  for (size_t frame = 0; frame < 4; ++frame) {
    EXPECT_EQ(sequence.detections[frame].size(), 2U);
    ExpectDetectionsAroundTheirObjects(sequence, truth, frame);
  }
  ExpectEdgesOfTheCategoriesMostlySeen(
      CsvTable(den / "edges_gt.csv", {"timestamp", "id", "edge", "x1", "y1", "x2", "y2", "visible"}), truth);
  // The odometry's frame is the first camera's.
  ASSERT_TRUE(sequence.up);
  const Eigen::Matrix3d R_camera_world = truth.T_world_camera.front().pose.linear().transpose();
  EXPECT_LT((*sequence.up - R_camera_world * Eigen::Vector3d::UnitZ()).norm(), 1e-5);
}

TEST(AppGenerate, IsDoneOnceUnlessAskedForSomethingElse) {
  const TempFolder folder;
  const auto den = folder / "out/den", picture = den / "rgb/0000.jpg";
  GenerateSmallScene(folder, 1);
  const auto written = std::filesystem::last_write_time(picture);
  const std::string first = ReadFile(picture);
  EXPECT_NE(GenerateSmallScene(folder, 1).out.find("there already"), std::string::npos);
  EXPECT_EQ(std::filesystem::last_write_time(picture), written);

  // More of it begins with the same.
  const std::vector<std::string> tables = {"detections.csv", "odometry.txt", "groundtruth.txt",
                                           "edges_gt.csv"};
  std::vector<std::string> before;
  for (const std::string& table : tables) before.push_back(ReadFile(den / table));
  EXPECT_EQ(GenerateSmallScene(folder, 2).out.find("there already"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(den / "rgb/0001.jpg"));
  EXPECT_EQ(ReadFile(picture), first);
  for (size_t i = 0; i < tables.size(); ++i) {
    EXPECT_GT(ReadFile(den / tables[i]).size(), before[i].size()) << tables[i];
    EXPECT_TRUE(ReadFile(den / tables[i]).starts_with(before[i])) << tables[i];
  }

  // Noise changes detections alone.
  GenerateSmallScene(folder, 1, {"--detection-noise", "2"});
  EXPECT_EQ(ReadFile(picture), first);
  EXPECT_NE(ReadFile(den / tables[0]), before[0]);
  for (size_t i = 1; i < tables.size(); ++i) EXPECT_EQ(ReadFile(den / tables[i]), before[i]) << tables[i];
}

TEST(AppGenerate, GivesTheSameBytesWhateverTheThreads) {
  const testing::StartedAnew anew;
  const TempFolder one, two;
  setenv("OMP_NUM_THREADS", "1", 1);
  GenerateSmallScene(one, 3);
  setenv("OMP_NUM_THREADS", "2", 1);
  GenerateSmallScene(two, 3);
  unsetenv("OMP_NUM_THREADS");
  for (const std::string& file : AllFiles(one / "out/den")) {
    if (file == "rgb") continue;
    EXPECT_EQ(ReadFile(one / "out/den" / file), ReadFile(two / "out/den" / file)) << file;
  }
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
