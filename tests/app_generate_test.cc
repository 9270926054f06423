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

// The corners of every object's bounding box project around its detection, closely unless it is hidden.
void ExpectDetectionsAroundTheirObjects(const Sequence& sequence, const GroundTruth& truth, size_t frame,
                                        double least_overlap = 0.3) {
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
    EXPECT_GT(IntersectionOverUnion(around, box), least_overlap) << object->id;
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

// Small rooms with coarse light, in small pictures.
constexpr const char* kTinyRooms =
    "name: tiny\nframes: 4\nfps: 2\nlight_grid: 0.3\ncamera: {size: 120x90, focal: 0.8}\n"
    "room: {width: [4.5, 5], depth: [4.5, 5], lamps: 1}\n"
    "layout:\n  - {group: dining, count: 1, chairs: [3, 4]}\n  - {group: free, count: 1}\n"
    "distractors: {count: 1}\npath: {kind: arc, height: 1.4, pitch_deg: 15, speed: 0.5}\n"
    "detections: {missed: 0, false_alarms: 0, min_visible: 0.05, min_size_px: 4}\n";

void ExpectASoundRoom(const std::filesystem::path& folder) {
  const Sequence sequence = LoadSequence(folder, {"chair", "table", "laptop"});
  const GroundTruth truth = LoadGroundTruth(folder);
  EXPECT_EQ(sequence.images.size(), 4U);
  EXPECT_GE(truth.objects.size(), 3U);
  size_t detections = 0;
  for (size_t frame = 0; frame < 4; ++frame) {
    detections += sequence.detections[frame].size();
    ExpectDetectionsAroundTheirObjects(sequence, truth, frame, 0);
  }
  EXPECT_GT(detections, 4U);
  for (const TrueObject& object : truth.objects)
    EXPECT_TRUE(object.instance.starts_with("armature:") && object.instance.ends_with("0"))
        << object.instance;
}

TEST(AppGenerate, DrawsRoomsWithTheirTruthAndSplits) {
  const TempFolder folder;
  const std::string recipe = folder.Write("tiny.yaml", kTinyRooms);
  const auto out = folder / "out";
  RunOk({"generate", "--rooms", recipe, "--count", "2", "--out", out});
  for (const char* name : {"tiny-development-000", "tiny-development-001"}) {
    ExpectASoundRoom(out / name);
    EXPECT_EQ(ReadFile(out / name / "scene.yaml"), ReadFile(out / (std::string(name) + ".yaml")));
  }
  EXPECT_NE(ReadFile(out / "tiny-development-000/objects_gt.csv"),
            ReadFile(out / "tiny-development-001/objects_gt.csv"));
  EXPECT_GT(cv::imread((out / "tiny-development.jpg").string()).cols, 0);

  // A room alone is the same, and is made once.
  RunOk({"generate", "--rooms", recipe, "--count", "1", "--first", "1", "--out", folder / "alone"});
  for (const std::string& file : AllFiles(out / "tiny-development-001")) {
    if (file == "rgb") continue;
    EXPECT_EQ(ReadFile(folder / "alone/tiny-development-001" / file),
              ReadFile(out / "tiny-development-001" / file))
        << file;
  }
  EXPECT_NE(RunOk({"generate", "--rooms", recipe, "--count", "1", "--out", out}).out.find("there already"),
            std::string::npos);

  // Its scene file can be rendered again, and the check split has other rooms.
  RunOk({"generate", "--scene", (out / "tiny-development-001.yaml").string(), "--without-cad", "--out",
         folder / "again"});
  EXPECT_EQ(ReadFile(folder / "again/tiny-development-001/rgb/0002.jpg"),
            ReadFile(out / "tiny-development-001/rgb/0002.jpg"));
  RunOk({"generate", "--rooms", recipe, "--count", "1", "--split", "check", "--out", out});
  EXPECT_NE(ReadFile(out / "tiny-check-000/objects_gt.csv"),
            ReadFile(out / "tiny-development-000/objects_gt.csv"));
}

TEST(AppGenerate, ReportsWhatItCannotDraw) {
  const TempFolder folder;
  const std::string recipe = folder.Write("tiny.yaml", kTinyRooms), out = folder / "out";
  ExpectBadInput({"generate", "--rooms", recipe, "--out", out}, {"--rooms", "--count"});
  ExpectBadInput({"generate", "--count", "2", "--out", out}, {"--count", "--rooms"});
  ExpectBadInput({"generate", "--rooms", recipe, "--count", "1", "--only", "seq1", "--out", out}, {"--only"});
  ExpectBadInput({"generate", "--rooms", recipe, "--count", "1", "--split", "chek", "--out", out},
                 {"--split", "chek", "check"});
  ExpectBadInput(
      {"generate", "--rooms", recipe, "--count", "1", "--split", "check", "--seed", "3", "--out", out},
      {"--split", "--seed"});
  ExpectBadInput({"generate", "--rooms", recipe, "--count", "1", "--collection", out, "--out", out},
                 {"no annotated CAD models"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace armature
