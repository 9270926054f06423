// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/statistics.h"
#include "io/placed_objects.h"
#include "io/run_writer.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::ReadFile;

CategoryModel TwoEdges() {
  CategoryModel model;
  model.spec.name = "corner";
  model.spec.edge_names = {"left", "right"};
  model.spec.padding = Eigen::Vector3d::Constant(0.05);
  // Two edges of 1 m; the first mode makes both 0.1 m longer.
  model.mean = Eigen::VectorXd::Zero(12);
  model.mean << 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0;
  model.basis = Eigen::MatrixXd::Zero(12, 2);
  model.basis(3, 0) = model.basis(10, 0) = std::sqrt(0.5);
  model.basis(0, 1) = 1;
  model.standard_deviations = Eigen::Vector2d(0.1 * std::sqrt(2.0), 0.1);
  return model;
}

ObjectObservation OkObservation() {
  ObjectObservation observation;
  observation.detection.category = "corner";
  ObjectEstimate& estimate = observation.estimate;
  estimate.status = EstimateStatus::kOk;
  estimate.T_camera_object.linear() = Eigen::AngleAxisd(3.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
  estimate.T_camera_object.translation() = Eigen::Vector3d(0.5, -0.25, 2);
  estimate.coefficients = Eigen::Vector2d(1.5, -1e-9);
  estimate.cost = 0.125;
  estimate.probability = 0.75;
  estimate.matches = {{1, {{1, 2}, {3, 4}}, 0.5}, {1, {{5, 6}, {7, 8}}, 0.25}};
  return observation;
}

FrameResult SampleFrame() {
  FrameResult frame;
  frame.timestamp = 0.2;
  frame.segments.resize(7);
  frame.observations = {OkObservation(), OkObservation()};
  frame.observations[1].estimate = {};
  frame.times = {.load = 100, .lines = 1, .association = 2, .optimization = 3, .mapping = 4};
  return frame;
}

class RunWriterTest : public ::testing::Test {
 protected:
  void WriteRun(const std::filesystem::path& run) const {
    RunWriter writer(run, {model_});
    writer.WriteConfig("seed: 1\n");
    writer.AddFrame(SampleFrame());
    writer.WriteMaps(SampleMap(1), SampleMap(2));
    writer.AddSkippedImage(0.4, "rgb/1.png: is not an image");
    writer.Finish(
        {.sequence = "tiny",
         .preset = "default",
         .odometry = {.poses = 9, .images = 4, .images_with_pose = 3, .gaps = 1, .longest_gap = 0.5}});
  }

  // One camera, one object `distance` metres in front of it, seen by the frame's first detection.
  Map SampleMap(double distance) const {
    Map map;
    map.timestamps = {0.2};
    map.T_world_camera = {Eigen::Isometry3d::Identity()};
    map.objects.resize(1);
    map.objects[0].id = "corner0";
    map.objects[0].model = &model_;
    map.objects[0].T_world_object.translation().z() = distance;
    map.objects[0].coefficients = Eigen::Vector2d(2, 0.5);
    map.objects[0].observations = 4;
    map.phi = {{0, -1}};
    map.log_scale = {0, 0};
    return map;
  }

  // Names in the test's folder, to see what is left behind.
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  CategoryModel model_ = TwoEdges();
  testing::TempFolder folder_;
};

TEST_F(RunWriterTest, WritesObservations) {
  WriteRun(folder_ / "run");
  EXPECT_EQ(
      ReadFile(folder_ / "run/observations.csv"),
      "timestamp,index,status,object,cost,edges_matched,tx,ty,tz,qx,qy,qz,qw,shape,ambiguous,probability\n"
      "0.200000,0,ok,corner0,0.125000,1,0.500000,-0.250000,2.000000,"
      "0.000000000,-0.983985947,0.000000000,0.178246056,1.500000;0.000000,0,0.7500\n"
      "0.200000,1,too_few_edges,,,0,,,,,,,,,,\n");
}

TEST_F(RunWriterTest, WritesAssociationsByEdgeName) {
  WriteRun(folder_ / "run");
  EXPECT_EQ(ReadFile(folder_ / "run/associations.csv"),
            "timestamp,index,edge,segment_x1,segment_y1,segment_x2,segment_y2,cost\n"
            "0.200000,0,right,1.000,2.000,3.000,4.000,0.5000\n"
            "0.200000,0,right,5.000,6.000,7.000,8.000,0.2500\n");
}

TEST_F(RunWriterTest, WritesTimesTrajectoriesAndConfig) {
  WriteRun(folder_ / "run");
  EXPECT_NE(ReadFile(folder_ / "run/timings.csv")
                .find("\n0.200000,2,7,100.0000,1.0000,2.0000,3.0000,4.0000,10.0000\n"),
            std::string::npos);
  EXPECT_EQ(ReadFile(folder_ / "run/config.yaml"), "seed: 1\n");
  EXPECT_EQ(ReadTumTrajectory(folder_ / "run/trajectory.txt").size(), 1u);
  EXPECT_EQ(ReadTumTrajectory(folder_ / "run/odometry_scaled.txt").size(), 1u);
}

TEST_F(RunWriterTest, WritesTheMapsObjectsWithTheirSizes) {
  WriteRun(folder_ / "run");
  const std::string header =
      "id,category,instance,tx,ty,tz,qx,qy,qz,qw,size_x,size_y,size_z,observations,shape,probability,"
      "covariance\n";
  // 1.2 m long edges, the first moved by 0.05 m: from -0.55 to 0.65; padding on both sides.
  const std::string rest =
      "0.000000000,0.000000000,0.000000000,1.000000000,1.300000,1.300000,0.100000,4,2.000000;0.500000";
  EXPECT_EQ(ReadFile(folder_ / "run/objects.csv"),
            header + "corner0,corner,,0.000000,0.000000,1.000000," + rest + ",,\n");
  EXPECT_EQ(ReadFile(folder_ / "run/objects_odometry.csv"),
            header + "corner0,corner,,0.000000,0.000000,2.000000," + rest + ",,\n");
}

TEST_F(RunWriterTest, WhatTheMapIsNotSureOfComesBack) {
  Map map = SampleMap(1);
  PoseAndSizeCovariance covariance = PoseAndSizeCovariance::Identity();
  covariance(1, 7) = covariance(7, 1) = -0.25;
  map.objects[0].uncertainty = {0.875, covariance};
  RunWriter writer(folder_ / "run", {model_});
  writer.WriteMaps(map, SampleMap(2));
  writer.Finish({.sequence = "tiny", .preset = "default"});
  const std::vector<PlacedObject> objects = ReadPlacedObjects(folder_ / "run/objects.csv");
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].probability, 0.875);
  EXPECT_EQ(objects[0].covariance, covariance);
  EXPECT_FALSE(ReadPlacedObjects(folder_ / "run/objects_odometry.csv")[0].covariance);
}

TEST_F(RunWriterTest, SummaryExplainsTheRun) {
  WriteRun(folder_ / "run");
  const auto summary = nlohmann::json::parse(ReadFile(folder_ / "run/summary.json"));
  EXPECT_EQ(summary["complete"], true);
  EXPECT_EQ(summary["sequence"], "tiny");
  EXPECT_EQ(summary["counts"]["frames"], 1);
  EXPECT_EQ(summary["counts"]["skipped_images"], 1);
  EXPECT_EQ(summary["counts"]["observations"]["ok"], 1);
  EXPECT_EQ(summary["counts"]["observations"]["too_few_edges"], 1);
  EXPECT_EQ(summary["counts"]["observations"]["diverged"], 0);
  EXPECT_EQ(summary["odometry"]["poses"], 9);
  EXPECT_EQ(summary["odometry"]["images_with_pose"], 3);
  EXPECT_EQ(summary["odometry"]["gaps"], 1);
  EXPECT_EQ(summary["odometry"]["longest_gap_s"], 0.5);
  EXPECT_EQ(summary["skipped"][0]["reason"], "rgb/1.png: is not an image");
  EXPECT_EQ(summary["stages_ms"]["total"]["median"], 10);
  EXPECT_GT(summary["peak_memory_mb"], 1);
  EXPECT_GE(summary["wall_seconds"], 0);
  for (const std::string key : {"opencv", "eigen", "ceres", "compiler"}) {
    EXPECT_FALSE(summary["versions"][key].get<std::string>().empty());
  }
  EXPECT_TRUE(summary["git"].contains("commit"));
  EXPECT_TRUE(summary["machine"].contains("cpu"));
}

TEST_F(RunWriterTest, ARunWithoutFramesHasNoMedians) {
  RunWriter(folder_ / "run", {}).Finish({});
  const auto summary = nlohmann::json::parse(ReadFile(folder_ / "run/summary.json"));
  EXPECT_TRUE(summary["stages_ms"]["lines"]["median"].is_null());
}

TEST_F(RunWriterTest, TheFolderIsAbsentUntilItIsComplete) {
  {
    RunWriter writer(folder_ / "run", {TwoEdges()});
    writer.AddFrame(SampleFrame());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
  }
  EXPECT_TRUE(Names().empty());
}

TEST_F(RunWriterTest, ReplacesAFinishedRunOnlyWhenTheNewOneIsComplete) {
  WriteRun(folder_ / "run");
  folder_.Write("run/old", "");
  { const RunWriter abandoned(folder_ / "run", {}); }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "run/old"));
  WriteRun(folder_ / "run/");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/old"));
  EXPECT_EQ(Names(), std::vector<std::string>{"run"});
}

TEST_F(RunWriterTest, TakesAnEmptyFolderAndCreatesTheFoldersAround) {
  std::filesystem::create_directory(folder_ / "run");
  WriteRun(folder_ / "run");
  WriteRun(folder_ / "a/b/run");
  EXPECT_TRUE(IsCompleteRun(folder_ / "run"));
  EXPECT_TRUE(IsCompleteRun(folder_ / "a/b/run"));
}

TEST_F(RunWriterTest, LeavesForeignFoldersAlone) {
  folder_.Write("photos/holiday.jpg", "precious");
  ExpectInputError([&] { WriteRun(folder_ / "photos"); }, {"photos", "not a finished run"});
  folder_.Write("half/summary.json", "{\"complete\": false}");
  ExpectInputError([&] { WriteRun(folder_ / "half"); }, {"half", "not a finished run"});
  folder_.Write("broken/summary.json", "{\"complete\": ");
  ExpectInputError([&] { WriteRun(folder_ / "broken"); }, {"broken"});
  folder_.Write("file", "precious");
  ExpectInputError([&] { WriteRun(folder_ / "file"); }, {"file", "not a finished run"});
  ExpectInputError([&] { WriteRun(folder_ / "file/run"); }, {"file/run", "is a file"});
  EXPECT_EQ(ReadFile(folder_ / "photos/holiday.jpg"), "precious");
  EXPECT_EQ(ReadFile(folder_ / "file"), "precious");
  EXPECT_EQ(Names().size(), 4u);
}

TEST_F(RunWriterTest, LeavesAFolderAloneThatAppearedDuringTheRun) {
  RunWriter writer(folder_ / "run", {});
  folder_.Write("run/notes.txt", "precious");
  ExpectInputError([&] { writer.Finish({}); }, {"run"});
  EXPECT_EQ(ReadFile(folder_ / "run/notes.txt"), "precious");
}

TEST_F(RunWriterTest, SameInputGivesTheSameBytes) {
  WriteRun(folder_ / "a");
  WriteRun(folder_ / "b");
  for (const std::string file : {"observations.csv", "associations.csv", "trajectory.txt", "config.yaml"}) {
    EXPECT_EQ(ReadFile(folder_ / ("a/" + file)), ReadFile(folder_ / ("b/" + file)));
  }
}

TEST(Quantile, InterpolatesBetweenNeighbours) {
  EXPECT_FALSE(Quantile({}, 0.5));
  EXPECT_EQ(Quantile({3}, 0.99), 3);
  EXPECT_EQ(Quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_NEAR(*Quantile({10, 0}, 0.9), 9, 1e-12);
  EXPECT_EQ(Quantile({4, 1, 3, 2}, 1), 4);
}

}  // namespace
}  // namespace armature
