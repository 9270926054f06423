// SPDX-License-Identifier: BSD-3-Clause
// What a report takes from runs, on a small true world.
#include <gtest/gtest.h>

#include "eval/report/overlay_frames.h"
#include "eval/report/report_sources.h"
#include "eval/report/retrieval_strips.h"
#include "eval/report/top_down_map.h"
#include "support/expect_input_error.h"
#include "support/true_map.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::MapText;
using testing::SameName;
using testing::TrueMap;
using testing::TrueWorld;
using testing::Unchanged;

TEST(ReportMap, PageIsSeenFromAbove) {
  // z up: as the axes of a map.
  Eigen::Matrix<double, 2, 3> to_page = PageFromWorld({0, 0, 1});
  EXPECT_TRUE((to_page * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector2d(1, 2)));
  // y down as cameras have it: what is ahead is up on the page.
  to_page = PageFromWorld({0, -1, 0});
  EXPECT_TRUE((to_page * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector2d(1, 3)));
  // The world's x axis is vertical.
  to_page = PageFromWorld({1, 0, 0});
  EXPECT_TRUE((to_page * Eigen::Vector3d(5, 2, 3)).isApprox(Eigen::Vector2d(3, -2)));
}

TEST(ReportFrames, PickRichestParts) {
  EXPECT_EQ(PickRichestParts({0, 3, 1, 0, 0, 0, 2, 2, 2}, 3), (std::vector<size_t>{1, 7}));
  EXPECT_EQ(PickRichestParts({1, 1}, 6), (std::vector<size_t>{0, 1}));
  EXPECT_TRUE(PickRichestParts({}, 6).empty());
}

TEST(ReportStrips, CropHasAMarginInsideTheImage) {
  EXPECT_EQ(CropAround({100, 50, 100, 50}, {640, 480}), cv::Rect(88, 38, 124, 74));
  EXPECT_EQ(CropAround({0, 0, 100, 50}, {640, 480}), cv::Rect(0, 0, 112, 62));
  EXPECT_EQ(CropAround({560, 440, 80, 40}, {640, 480}), cv::Rect(550, 430, 90, 50));
}

// A run whose map is the true one, but for the chair, which is 0.1 m off, told in another world.
class ReportOfTrueWorld : public ::testing::Test {
 protected:
  ReportOfTrueWorld() {
    AddRun("mine", true);
    sources_.models = world_.models;
  }

  void AddRun(const std::string& name, bool loop_closure) {
    Similarity T_run_truth;
    T_run_truth.R = ExpSO3({0.5, 0, 1});
    T_run_truth.t = {1, 2, 3};
    std::vector<PlacedObject> map = TrueMap(world_.sequence.truth);
    map[0].T_world_object.translation().x() += 0.1;
    for (PlacedObject& object : map) object.shape.assign(ModesOf(object.category), 0.0);
    world_.WriteRun(name, Unchanged, SameName);
    WriteMap(world_, name, map, T_run_truth);
    world_.folder.Write(name + "/config.yaml", fmt::format("mapping:\n  loop_closure: {}\n", loop_closure));
    sources_.runs.push_back({world_.folder / name, world_.folder / "sequence", name});
  }

  size_t ModesOf(const std::string& category) const {
    return static_cast<size_t>(LookUpModel(world_.models, category).modes());
  }

  TrueWorld world_;
  ReportSources sources_;
};

TEST_F(ReportOfTrueWorld, MapsAreMovedToTheTruthWithTheTablesErrors) {
  AddRun("second", true);
  AddRun("open", false);
  const ReportData data = CollectReport(sources_);
  ASSERT_EQ(data.maps.size(), 1u);
  const TopDownMap& map = data.maps[0];
  EXPECT_EQ(map.sequence, "world");
  ASSERT_EQ(map.estimates.size(), 4u);
  EXPECT_EQ(map.estimates[0].name, "mine: objects, loop closure");
  EXPECT_EQ(map.estimates[1].name, "open: objects, no loop closure");
  EXPECT_EQ(map.estimates[2].name, "odometry only");
  EXPECT_EQ(map.estimates[3].name, "second: objects, loop closure");
  ASSERT_TRUE(map.truth);
  const MapLayer& mine = map.estimates[0];
  ASSERT_EQ(mine.objects.size(), 2u);
  EXPECT_NEAR(mine.objects[0].error_m.value(), 0.1, 1e-6);
  EXPECT_NEAR(mine.objects[1].error_m.value(), 0.0, 1e-6);
  for (size_t i = 0; i < 4; ++i)
    EXPECT_NEAR((mine.objects[1].footprint[i] - map.truth->objects[1].footprint[i]).norm(), 0, 1e-6);
  EXPECT_NEAR((mine.objects[1].footprint[1] - mine.objects[1].footprint[2]).norm(), 0.6, 0.05);
  EXPECT_NEAR((mine.trajectory[1] - map.truth->trajectory[1]).norm(), 0, 1e-6);
}

TEST_F(ReportOfTrueWorld, TheSceneIsInTheTrueWorld) {
  const ReportData data = CollectReport(sources_);
  ASSERT_EQ(data.scenes.size(), 1u);
  const SceneView& scene = data.scenes[0];
  ASSERT_EQ(scene.path.size(), 2u);
  EXPECT_NEAR((scene.path[1] - Eigen::Vector3d(0.2, 0, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((scene.cameras[0][0] - scene.path[0]).norm(), 0, 1e-6);
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[0].wireframe.size(), 11u);
  EXPECT_EQ(scene.objects[0].true_box.size(), 12u);
  EXPECT_EQ(scene.objects[0].cad.size(), 0);
  double longest = 0;
  for (const auto& [a, b] : scene.objects[1].true_box) longest = std::max(longest, (a - b).norm());
  EXPECT_NEAR(longest, 1.2, 1e-6);
}

TEST_F(ReportOfTrueWorld, WithoutTruthTheMapIsAsItIs) {
  for (const char* file : {"groundtruth.txt", "objects_gt.csv", "detections_gt.csv"})
    std::filesystem::remove(world_.folder / "sequence" / file);
  const ReportData data = CollectReport(sources_);
  ASSERT_EQ(data.maps.size(), 1u);
  EXPECT_FALSE(data.maps[0].truth);
  EXPECT_FALSE(data.maps[0].estimates[0].objects[0].error_m);
  ASSERT_EQ(data.scenes.size(), 1u);
  EXPECT_TRUE(data.scenes[0].true_path.empty());
  EXPECT_NEAR((data.scenes[0].path[0] - Eigen::Vector3d(1, 2, 3)).norm(), 0, 1e-6);
  ASSERT_EQ(data.remarks.size(), 3u);
  EXPECT_NE(data.remarks[0].find("no ground truth"), std::string::npos);
  EXPECT_NE(data.remarks[1].find("rgb.txt"), std::string::npos) << "the sequence has no images";
  EXPECT_NE(data.remarks[2].find("armature retrieve"), std::string::npos);
}

TEST_F(ReportOfTrueWorld, RetrievedModelsAreNamed) {
  world_.folder.Write("mine/retrieval.csv",
                      "object,rank,instance,distance,cost,tx,ty,tz,qx,qy,qz,qw,scale\n"
                      "map_chair0,1,keypointnet:b,0.5,,,,,,,,,\n"
                      "map_chair0,2,keypointnet:abc,0.75,2,0,0,0,0,0,0,1,1\n");
  const ReportData data = CollectReport(sources_);
  ASSERT_EQ(data.strips.size(), 1u);
  EXPECT_EQ(data.strips[0].object, "map_chair0");
  EXPECT_EQ(data.strips[0].true_model, "keypointnet:abc");
  ASSERT_EQ(data.strips[0].models.size(), 2u);
  EXPECT_FALSE(data.strips[0].models[0].is_true);
  EXPECT_EQ(data.strips[0].models[0].detail, "distance 0.50");
  EXPECT_TRUE(data.strips[0].models[1].is_true);
  EXPECT_EQ(data.strips[0].models[1].detail, "cost 2.00, distance 0.75");
  EXPECT_FALSE(data.strips[0].models[1].picture) << "there is no library";

  world_.folder.Write("mine/retrieval.csv",
                      "object,rank,instance,distance,cost,tx,ty,tz,qx,qy,qz,qw,scale\n"
                      "map_chair0,2,keypointnet:b,0.5,,,,,,,,,\n");
  ExpectInputError([&] { CollectReport(sources_); }, {"retrieval.csv:2", "ranks"});
}

TEST_F(ReportOfTrueWorld, ManyRoomsAreSummedUpAndTheWorstShown) {
  sources_.tables = {
      {.title = "Variants over rooms", .columns = {"variant"}, .rows = {}, .notes = {}, .name = "rooms"}};
  sources_.records.rooms = {{.run = "mine", .statistic = "found_share", .rooms = 40}};
  sources_.records.worst_rooms = {{.run = "mine", .sequence = "world", .folder = "mine", .error_m = 1}};
  sources_.records.room_errors = {{"mine", {0.1, 0.2}, 1}};
  const ReportData data = CollectReport(sources_);
  ASSERT_FALSE(data.tables.empty());
  EXPECT_EQ(data.tables[0].section, ReportSection::kOverview);
  EXPECT_EQ(data.distributions.size(), 1u);
  const auto is_told = [](const std::string& remark) {
    return remark.find("40 rooms") != std::string::npos &&
           remark.find("the 1 in which 'mine'") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(data.remarks.begin(), data.remarks.end(), is_told));
}

TEST_F(ReportOfTrueWorld, AMapWithoutObjectsIsNotShown) {
  for (const char* file : {"mine/objects.csv", "mine/objects_odometry.csv"})
    world_.folder.Write(file, MapText({}));
  for (const char* file : {"mine/trajectory.txt", "mine/odometry_scaled.txt"})
    world_.folder.Write(file, "# no odometry\n");
  const ReportData data = CollectReport(sources_);
  EXPECT_TRUE(data.maps.empty());
  EXPECT_TRUE(data.scenes.empty());
  EXPECT_EQ(data.remarks.back(), "world: no run has a map with objects");
}

TEST_F(ReportOfTrueWorld, ShapesOfOtherModelsAreRefused) {
  std::vector<PlacedObject> map = TrueMap(world_.sequence.truth);  // two coefficients
  world_.folder.Write("mine/objects.csv", MapText(map));
  ExpectInputError([&] { CollectReport(sources_); }, {"mine/objects.csv", "map_chair0", "--categories"});
}

}  // namespace
}  // namespace armature
