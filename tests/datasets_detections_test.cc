// SPDX-License-Identifier: BSD-3-Clause
// The simulated detector and viewpoint estimator, and what they see.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "datasets/cad/solids.h"
#include "datasets/simulation/detections.h"
#include "datasets/simulation/visible_objects.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr DetectionNoise kExactDetections{.box = 0,
                                          .missed = 0,
                                          .false_alarms = 0,
                                          .min_visible = 0.3,
                                          .min_size_px = 20,
                                          .azimuth_deg = 0,
                                          .elevation_deg = 0,
                                          .tilt_deg = 0,
                                          .turned = 0};
const Camera kCamera{640, 480, 500, 500, 319.5, 239.5};
const Eigen::Isometry3d kCameraPose = Eigen::Isometry3d::Identity();  // x right, y down, z forward

std::vector<DetectableObject> TwoObjects() {
  std::vector<DetectableObject> objects = {{"a", "chair"}, {"b", "table"}};
  objects[0].T_world_object.translation() = Eigen::Vector3d(0, 0, 3);
  objects[0].T_world_object.linear() =
      RotationFromViewpoint({0.4, 0.2, 0.05}, objects[0].T_world_object.translation());
  objects[1].T_world_object.translation() = Eigen::Vector3d(1, 0, 4);
  return objects;
}

VisibleObject Visible(int object, double share) {
  return {object, {270, 190, 99, 99}, share};  // around the middle of the picture
}

std::vector<SimulatedDetection> Detected(const std::vector<VisibleObject>& visible,
                                         const DetectionNoise& noise, std::uint64_t seed = 1) {
  return SimulateDetections({{0, kCameraPose, visible}}, {kCamera, TwoObjects(), {}}, {noise, {}}, seed)
      .front();
}

TEST(SimulatedDetections, WithoutNoiseAreTheTruth) {
  const auto found = Detected({Visible(1, 0.9)}, kExactDetections);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].id, "a");
  EXPECT_EQ(found[0].detection.category, "chair");
  EXPECT_NEAR(found[0].detection.box.x, 270, 1e-9);
  EXPECT_NEAR(found[0].detection.box.width, 99, 1e-9);
  EXPECT_NEAR(*found[0].detection.azimuth, 0.4, 1e-6);
  EXPECT_NEAR(*found[0].detection.elevation, 0.2, 1e-6);
  EXPECT_NEAR(*found[0].detection.tilt, 0.05, 1e-6);
}

TEST(SimulatedDetections, LeaveOutWhatIsHardlySeen) {
  EXPECT_TRUE(Detected({Visible(1, 0.29)}, kExactDetections).empty());
  VisibleObject small = Visible(1, 1);
  small.box.width = small.box.height = 19;
  EXPECT_TRUE(Detected({small}, kExactDetections).empty());
}

TEST(SimulatedDetections, AreSortedByScoreSoThatTheirOrderTellsNothing) {
  DetectionNoise noise = kExactDetections;
  noise.false_alarms = 2;
  const auto found = Detected({Visible(1, 0.4), Visible(2, 1)}, noise);
  ASSERT_EQ(found.size(), 4U);
  for (size_t i = 1; i < found.size(); ++i) EXPECT_GE(found[i - 1].detection.score, found[i].detection.score);
  EXPECT_EQ(found[0].id, "b");
}

// Counts over many pictures of one object.
struct Statistics {
  double missed = 0, turned = 0, false_alarms = 0, azimuth_sigma_deg = 0, left_sigma = 0;
};

Statistics Many(const DetectionNoise& noise) {
  constexpr int kPictures = 4000;
  Statistics s;
  int found = 0, straight = 0;
  for (int i = 0; i < kPictures; ++i) {
    bool is_found = false;
    for (const SimulatedDetection& d : Detected({Visible(1, 1)}, noise, static_cast<std::uint64_t>(i))) {
      const Box& box = d.detection.box;
      EXPECT_GE(box.left(), -0.5);
      EXPECT_LE(box.right(), 639.5 + 1e-9);
      EXPECT_GT(box.width, 0);
      EXPECT_GE(d.detection.score, 0);
      EXPECT_LE(d.detection.score, 1);
      if (d.id.empty()) {
        ++s.false_alarms;
        continue;
      }
      is_found = true;
      const double error = WrapAngle(*d.detection.azimuth - 0.4);
      if (std::abs(error) > 90 * kDegree) {
        ++s.turned;
      } else {
        s.azimuth_sigma_deg += error * error;
        ++straight;
      }
      s.left_sigma += (box.left() - 270) * (box.left() - 270);
    }
    is_found ? ++found : ++s.missed;
  }
  s.missed /= kPictures;
  s.false_alarms /= kPictures;
  s.turned /= found;
  s.azimuth_sigma_deg = std::sqrt(s.azimuth_sigma_deg / straight) / kDegree;
  s.left_sigma = std::sqrt(s.left_sigma / found);
  return s;
}

TEST(SimulatedDetections, AreWrongAsOftenAndAsMuchAsAsked) {
  DetectionNoise noise = kExactDetections;
  noise.box = 0.02;
  noise.missed = 0.1;
  noise.false_alarms = 0.3;
  noise.azimuth_deg = 10;
  noise.turned = 0.05;
  const Statistics s = Many(noise);
  EXPECT_NEAR(s.missed, 0.1, 0.015);
  EXPECT_NEAR(s.false_alarms, 0.3, 0.03);
  EXPECT_NEAR(s.turned, 0.05, 0.012);
  EXPECT_NEAR(s.left_sigma, 0.02 * 99, 0.1);
  EXPECT_NEAR(s.azimuth_sigma_deg, 10, 1);  // the ray through the noisy box adds a little
}

TEST(SimulatedDetections, NoiseIsMultiplied) {
  const DetectionNoise noise =
      DetectionNoise{.box = 0.02, .missed = 0.6, .azimuth_deg = 10, .turned = 0.04}.Times(2);
  EXPECT_EQ(noise.box, 0.04);
  EXPECT_EQ(noise.missed, 1);
  EXPECT_EQ(noise.azimuth_deg, 20);
  EXPECT_EQ(noise.turned, 0.08);
  EXPECT_EQ(noise.min_visible, DetectionNoise().min_visible);
}

// A cube of 0.4 m at 2 m, and a board that hides a part of it.
std::vector<PlacedMesh> CubeBehindBoard(double board_right) {
  PlacedMesh cube, board;
  cube.mesh.parts = {Block(Eigen::Vector3d(-0.2, -0.2, 2), Eigen::Vector3d(0.2, 0.2, 2.4), {})};
  cube.object = 1;
  board.mesh.parts = {Block(Eigen::Vector3d(-2, -2, 1), Eigen::Vector3d(board_right, 2, 1.01), {})};
  return {cube, board};
}

cv::Mat1i ObjectsSeen(const RayScene& rays) {
  cv::Mat1i objects(kCamera.height, kCamera.width);
  for (int row = 0; row < objects.rows; ++row) {
    for (int column = 0; column < objects.cols; ++column)
      objects(row, column) = rays.Nearest({0, 0, 0}, kCamera.Ray({column, row}).normalized()).object;
  }
  return objects;
}

TEST(VisibleObjects, ABoxIsAroundTheVisiblePixels) {
  const RayScene rays(CubeBehindBoard(-1));
  const auto visible = VisibleObjects(rays, ObjectsSeen(rays), kCamera, kCameraPose);
  ASSERT_EQ(visible.size(), 1U);
  EXPECT_EQ(visible[0].object, 1);
  EXPECT_NEAR(visible[0].box.left(), 319.5 - 50, 1);
  EXPECT_NEAR(visible[0].box.width, 100, 1.01);
  EXPECT_NEAR(visible[0].visible_share, 1, 1e-9);
}

TEST(VisibleObjects, HalfHiddenIsHalfVisible) {
  const RayScene rays(CubeBehindBoard(0));
  const auto visible = VisibleObjects(rays, ObjectsSeen(rays), kCamera, kCameraPose);
  ASSERT_EQ(visible.size(), 1U);
  EXPECT_NEAR(visible[0].box.left(), 319.5, 1);
  EXPECT_NEAR(visible[0].visible_share, 0.5, 0.06);
}

TEST(VisibleObjects, CutByThePictureIsNotAllVisible) {
  const RayScene rays(CubeBehindBoard(-1));
  Camera shifted = kCamera;
  shifted.cx = 0;  // the cube's left half is outside
  cv::Mat1i objects(kCamera.height, kCamera.width, kRoom);
  objects.colRange(0, 50).rowRange(190, 289) = 1;
  const auto visible = VisibleObjects(rays, objects, shifted, kCameraPose);
  ASSERT_EQ(visible.size(), 1U);
  EXPECT_NEAR(visible[0].visible_share, 0.5, 0.06);
}

TEST(VisibleObjects, WhatIsNotSeenIsNotThere) {
  const RayScene rays(CubeBehindBoard(1));
  EXPECT_TRUE(VisibleObjects(rays, ObjectsSeen(rays), kCamera, kCameraPose).empty());
}

}  // namespace
}  // namespace armature
