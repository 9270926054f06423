// SPDX-License-Identifier: BSD-3-Clause
// The built-in sample and what it is drawn with.
#include "datasets/sample.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "datasets/furniture.h"
#include "datasets/rasterizer.h"
#include "datasets/simulated_odometry.h"
#include "eval/ground_truth.h"
#include "geometry/rotation.h"
#include "io/sequence.h"
#include "support/expect_input_error.h"
#include "support/program.h"

namespace armature {
namespace {

using testing::AllFiles;
using testing::ExpectInputError;
using testing::ReadFile;
using testing::TempFolder;

Polygon Square(double half, double depth, int object) {
  Polygon square;
  square.corners = {{-half, -half, depth}, {half, -half, depth}, {half, half, depth}, {-half, half, depth}};
  square.normal = {0, 0, -1};
  square.object = object;
  return square;
}

TEST(Rasterizer, DrawsTheNearestPolygonWhereItProjects) {
  const Camera camera{40, 30, 20, 20, 19.5, 14.5};
  const VisibleSurfaces surfaces =
      Rasterize({Square(1, 4, 1), Square(0.2, 2, 2)}, camera, Eigen::Isometry3d::Identity());
  EXPECT_EQ(cv::countNonZero(surfaces.polygon == 1), 4 * 4);  // 20 * 0.2 / 2 = 2 pixels each way
  EXPECT_EQ(cv::countNonZero(surfaces.polygon == 0), 10 * 10 - 4 * 4);
  EXPECT_EQ(surfaces.polygon(15, 20), 1);
  EXPECT_NEAR(surfaces.inverse_depth(15, 20), 0.5, 1e-12);
  EXPECT_EQ(surfaces.polygon(0, 0), -1);
}

TEST(Rasterizer, LeavesOutWhatIsBehindOrTurnedAway) {
  const Camera camera{40, 30, 20, 20, 19.5, 14.5};
  Polygon turned = Square(1, 4, 1);
  turned.normal = -turned.normal;
  const VisibleSurfaces surfaces =
      Rasterize({turned, Square(1, -4, 2)}, camera, Eigen::Isometry3d::Identity());
  EXPECT_EQ(cv::countNonZero(surfaces.polygon != -1), 0);
}

TEST(Rasterizer, TheFineCameraHasTheSamePixelsHalved) {
  const Camera camera{640, 480, 525, 520, 319.5, 239.5}, fine = TwiceAsFine(camera);
  const Eigen::Vector3d point(0.3, -0.2, 2);
  const Eigen::Vector2d pixel = camera.Project(point), fine_pixel = fine.Project(point);
  EXPECT_LT((fine_pixel - (2 * pixel + Eigen::Vector2d(0.5, 0.5))).norm(), 1e-9);
}

TEST(Furniture, IsCentredAndOfItsSize) {
  const Furniture chair = SolidChair({.width = 0.5, .height = 0.9}, {1, 1, 1}, {1, 1, 1}, "test:chair");
  const Eigen::AlignedBox3d box = BoundingBox(chair.parts);
  EXPECT_LT(box.center().norm(), 1e-9);
  EXPECT_NEAR(chair.size.x(), 0.5, 1e-9);
  EXPECT_NEAR(chair.size.y(), 0.9, 0.01);
  const Furniture table =
      SolidTable({.width = 1.2, .depth = 0.7, .height = 0.75}, {1, 1, 1}, {1, 1, 1}, "test:table");
  EXPECT_LT((table.size - Eigen::Vector3d(1.2, 0.75, 0.7)).norm(), 1e-9);
}

TEST(Furniture, AChairsBackIsAtTheRear) {
  const Furniture chair = SolidChair({}, {1, 1, 1}, {1, 1, 1}, "test:chair");
  double highest = -1, z_of_highest = 0;
  for (const Cuboid& part : chair.parts) {
    const Eigen::Vector3d centre = part.T_parent_cuboid.translation();
    if (centre.y() > highest) std::tie(highest, z_of_highest) = std::pair(centre.y(), centre.z());
  }
  EXPECT_LT(z_of_highest, 0);
}

TEST(Solids, ASegmentIsBlockedOnlyByWhatItMeets) {
  Cuboid cuboid;
  cuboid.T_parent_cuboid.translation() = Eigen::Vector3d(0, 0, 1);
  cuboid.T_parent_cuboid.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(Blocks(cuboid, {0, 0, -1}, {0, 0, 3}));
  EXPECT_TRUE(Blocks(cuboid, {-2, 0, 1}, {2, 0.1, 1}));
  EXPECT_FALSE(Blocks(cuboid, {0, 0, -1}, {0, 0, 0.2}));
  EXPECT_FALSE(Blocks(cuboid, {1, 0, -1}, {1, 0, 3}));
}

TEST(OdometrySimulator, StartsAtTheOriginAndScales) {
  OdometrySimulator odometry(1, 0.5);
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.translation() = Eigen::Vector3d(5, 6, 7);
  EXPECT_TRUE(odometry.Next(T_world_camera).isApprox(Eigen::Isometry3d::Identity()));
  T_world_camera.translation().x() += 2;
  EXPECT_LT((odometry.Next(T_world_camera).translation() - Eigen::Vector3d(1, 0, 0)).norm(), 0.06);
}

TEST(Sample, IsASequenceWithItsTruth) {
  const TempFolder folder;
  WriteSample(folder / "sample", {.frames = 3});
  const Sequence sequence = LoadSequence(folder / "sample", {"chair", "table", "laptop"});
  EXPECT_EQ(sequence.images.size(), 3u);
  EXPECT_FALSE(sequence.up);
  EXPECT_FALSE(sequence.odometry_metric);
  for (const auto& pose : sequence.T_odom_camera) EXPECT_TRUE(pose);
  const cv::Mat image = cv::imread(sequence.images.front().file.string());
  EXPECT_EQ(image.size(), cv::Size(640, 480));
  const GroundTruth truth = LoadGroundTruth(folder / "sample");
  EXPECT_EQ(truth.T_world_camera.size(), 3u);
  EXPECT_EQ(truth.objects.size(), 5u);
}

// The corners of every object's bounding box project around its detection, and priors are near the truth.
TEST(Sample, DetectionsAreWhereTheObjectsAre) {
  const TempFolder folder;
  WriteSample(folder / "sample", {.frames = 2});
  const Sequence sequence = LoadSequence(folder / "sample", {"chair", "table", "laptop"});
  const GroundTruth truth = LoadGroundTruth(folder / "sample");
  for (size_t i = 0; i < sequence.detections[0].size(); ++i) {
    const Detection& detection = sequence.detections[0][i];
    const TrueObject* object = truth.ObjectOf(0, static_cast<int>(i));
    ASSERT_NE(object, nullptr);
    EXPECT_EQ(object->category, detection.category);
    const Eigen::Isometry3d T_camera_object = *truth.TrueCameraObject(0, static_cast<int>(i));
    Eigen::AlignedBox2d corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      corners.extend(sequence.camera.Project(T_camera_object * object->size.cwiseProduct(sign)));
    }
    const Box around =
        Box{corners.min().x(), corners.min().y(), corners.sizes().x(), corners.sizes().y()}.Grown(12);
    EXPECT_NEAR(Intersection(around, detection.box).area(), detection.box.area(), 1) << object->id;
    const Viewpoint viewpoint =
        ViewpointFromRotation(T_camera_object.linear(), T_camera_object.translation());
    EXPECT_LT(std::abs(WrapAngle(*detection.azimuth - viewpoint.azimuth)), 30 * kDegree) << object->id;
  }
}

TEST(Sample, SameSeedSameBytesOtherSeedOthers) {
  const TempFolder folder;
  WriteSample(folder / "a", {.frames = 1, .seed = 3});
  WriteSample(folder / "b", {.frames = 1, .seed = 3});
  WriteSample(folder / "c", {.frames = 1, .seed = 4});
  EXPECT_EQ(AllFiles(folder / "a"), AllFiles(folder / "b"));
  for (const std::string& file : AllFiles(folder / "a")) {
    if (file == "rgb") continue;
    EXPECT_EQ(ReadFile(folder / "a" / file), ReadFile(folder / "b" / file)) << file;
  }
  EXPECT_NE(ReadFile(folder / "a/detections.csv"), ReadFile(folder / "c/detections.csv"));
  EXPECT_NE(ReadFile(folder / "a/rgb/0000.jpg"), ReadFile(folder / "c/rgb/0000.jpg"));
}

TEST(Sample, DoesNotReplaceWhatIsThere) {
  const TempFolder folder;
  folder.Write("sample/notes.txt", "precious");
  ExpectInputError([&] { WriteSample(folder / "sample", {.frames = 1}); }, {"sample", "exists"});
  EXPECT_EQ(AllFiles(folder.path()), (std::set<std::string>{"sample", "sample/notes.txt"}));
}

}  // namespace
}  // namespace armature
