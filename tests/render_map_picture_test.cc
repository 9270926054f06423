// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <omp.h>

#include <opencv2/core.hpp>

#include "drawing/map_models.h"
#include "drawing/map_picture.h"
#include "drawing/map_view.h"
#include "geometry/mesh_shapes.h"

namespace armature {
namespace {

using Eigen::Vector3d;

const MapPictureOptions kSmall{.width = 160, .height = 100, .samples = 4, .labels = false};
const MapPictureOptions kLarge{.width = 480, .height = 300, .samples = 4, .labels = false};

Eigen::Isometry3d PoseAt(const Vector3d& position) {
  return Eigen::Isometry3d(Eigen::Translation3d(position));
}

// Cubes of 1 m with nothing but their surface.
MapSceneObject CubeAt(const std::string& id, const Vector3d& centre) {
  return {id, "chair", PoseAt(centre), {}, BoxMesh(Vector3d::Zero(), Eigen::Matrix3d::Identity() / 2)};
}

// World with z up; three cubes on the floor at z = 0 in a row along x, one on top of the first; cameras to
// the south that look north.
MapScene RowOfCubes() {
  MapScene scene;
  scene.up_world = Vector3d::UnitZ();
  scene.objects = {CubeAt("a", {0, 0, 0.5}), CubeAt("b", {3, 0, 0.5}), CubeAt("c", {6, 0, 0.5}),
                   CubeAt("on a", {0, 0, 1.5})};
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  for (int i = 0; i <= 10; ++i) {
    camera.translation() = Vector3d(1 + 0.4 * i, -1.5, 1.2);
    scene.T_world_camera.push_back(camera);
  }
  return scene;
}

cv::Point PixelOf(const Vector3d& point, const MapView& view) {
  const Eigen::Vector2d pixel = view.camera.Project(view.T_world_camera.inverse() * point);
  return {cvRound(pixel.x()), cvRound(pixel.y())};
}

bool IsBlue(const cv::Vec3b& bgr) { return bgr[0] > bgr[2] + 30; }
bool IsPink(const cv::Vec3b& bgr) { return bgr[2] > bgr[1] + 60 && bgr[0] > bgr[1] + 20; }

TEST(MapView, LooksAsTheCamerasLookFromAboveAcrossTheShallowSide) {
  const MapView view = FrameMap(RowOfCubes(), 160, 100);
  const Vector3d looking = view.T_world_camera.linear().col(2);
  EXPECT_NEAR(looking.x(), 0, 1e-9);
  EXPECT_GT(looking.y(), 0.5);
  EXPECT_LT(looking.z(), -0.5);
  EXPECT_TRUE(view.T_world_camera.linear().col(0).isApprox(Vector3d::UnitX()));
}

TEST(MapView, FramesEverythingTightly) {
  const MapScene scene = RowOfCubes();
  const MapView view = FrameMap(scene, 160, 100);
  cv::Point low(1000, 1000), high(-1000, -1000);
  const auto extend = [&](const Vector3d& point) {
    const cv::Point pixel = PixelOf(point, view);
    low = {std::min(low.x, pixel.x), std::min(low.y, pixel.y)};
    high = {std::max(high.x, pixel.x), std::max(high.y, pixel.y)};
  };
  for (const MapSceneObject& object : scene.objects) {
    for (const auto& vertex : object.cad.vertices.colwise()) extend(object.T_world_object * vertex);
  }
  for (const int i : {0, 1, 2, 3}) {
    const Eigen::Vector2d corner = view.ground.area.corner(static_cast<Eigen::AlignedBox2d::CornerType>(i));
    extend(view.ground.T_world_ground * Vector3d(corner.x(), corner.y(), 0));
  }
  EXPECT_GE(low.x, 4);
  EXPECT_GE(low.y, 3);
  EXPECT_LE(high.x, 155);
  EXPECT_LE(high.y, 96);
  EXPECT_TRUE(high.x - low.x > 140 || high.y - low.y > 88);
}

TEST(MapView, TheFloorIsUnderWhatStandsOnIt) {
  const MapGround ground = FrameMap(RowOfCubes(), 160, 100).ground;
  EXPECT_NEAR(ground.T_world_ground.translation().z(), 0, 1e-9);
  EXPECT_TRUE(ground.T_world_ground.linear().col(2).isApprox(Vector3d::UnitZ()));
  EXPECT_NEAR(ground.area.sizes().x(), 8, 1e-9);  // 7 m of cubes and the margin, in whole metres
  EXPECT_NEAR(ground.area.sizes().y(), 3, 1e-9);
}

TEST(MapPicture, CubesAreWhereTheirProjectionIs) {
  const MapScene scene = RowOfCubes();
  const cv::Mat3b picture = DrawMap(scene, kSmall);
  const MapView view = FrameMap(scene, kSmall.width, kSmall.height);
  for (const double x : {0.0, 3.0, 6.0}) {
    EXPECT_TRUE(IsBlue(picture(PixelOf({x, -0.5, 0.5}, view)))) << x;  // the near face
    EXPECT_TRUE(IsBlue(picture(PixelOf({x - 0.45, -0.5, 0.1}, view)))) << x;
    EXPECT_FALSE(IsBlue(picture(PixelOf({x - 0.6, -0.5, 0.1}, view)))) << x;
  }
  EXPECT_EQ(picture(0, 0), cv::Vec3b(255, 255, 255));
  const cv::Vec3b lit = picture(PixelOf({1.3, -0.8, 0}, view)),
                  shadow = picture(PixelOf({3.58, 0.1, 0}, view));
  EXPECT_GT(lit[1], 210);
  EXPECT_LT(shadow[1], lit[1] - 20);  // the lamp is at the left
}

TEST(MapPicture, CamerasAreBallsAndThePathIsDotted) {
  const MapScene scene = RowOfCubes();
  const cv::Mat3b picture = DrawMap(scene, kLarge);
  const MapView view = FrameMap(scene, kLarge.width, kLarge.height);
  EXPECT_TRUE(IsPink(picture(PixelOf(scene.T_world_camera[0].translation(), view))));
  int dark = 0;
  for (const Vector3d& dot : PathDots(scene.T_world_camera, 0.07)) {
    const cv::Vec3b bgr = picture(PixelOf(dot, view));
    dark += bgr[0] < 120 && bgr[1] < 120 && bgr[2] < 120;
  }
  EXPECT_GT(dark, 20);
}

TEST(MapPicture, WireframesAreDrawnAlsoWhereTheCadModelHidesThem) {
  MapScene scene = RowOfCubes();
  const cv::Mat3b without = DrawMap(scene, kLarge);
  // Up through the middle of the cube, and on above it.
  scene.objects[1].wireframe = {Vector3d(0, 0, 0.45), Vector3d(0, 0, 1.8)};
  const cv::Mat3b with = DrawMap(scene, kLarge);
  const MapView view = FrameMap(scene, kLarge.width, kLarge.height);
  const auto darker = [&](const Vector3d& point) {
    const cv::Point pixel = PixelOf(point, view);
    int most = 0;
    for (int x = pixel.x - 1; x <= pixel.x + 1; ++x) {
      most = std::max(most, without(pixel.y, x)[0] - with(pixel.y, x)[0]);
    }
    return most;
  };
  EXPECT_GT(darker({3, 0, 1.7}), 80);
  EXPECT_GT(darker({3, 0, 0.5}), 5);
  EXPECT_LT(darker({3, 0, 0.5}), darker({3, 0, 1.7}));
}

TEST(MapPicture, LabelsAreAboveTheirObjects) {
  MapPictureOptions options = kLarge;
  const cv::Mat3b without = DrawMap(RowOfCubes(), options);
  options.labels = true;
  const cv::Mat3b with = DrawMap(RowOfCubes(), options);
  cv::Mat1b changed(without.size(), uchar(0));
  for (int y = 0; y < without.rows; ++y) {
    for (int x = 0; x < without.cols; ++x) changed(y, x) = without(y, x) != with(y, x);
  }
  const MapView view = FrameMap(RowOfCubes(), options.width, options.height);
  const cv::Point top = PixelOf({6, 0.5, 1}, view);
  EXPECT_GT(cv::countNonZero(changed(cv::Rect(top.x - 12, top.y - 24, 24, 24))), 20);
  EXPECT_EQ(cv::countNonZero(changed(cv::Rect(0, PixelOf({0, -0.5, 0}, view).y, with.cols, 20))), 0);
}

TEST(MapPicture, IsTheSameForAnyNumberOfThreads) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const cv::Mat one = DrawMap(RowOfCubes(), kSmall);
  omp_set_num_threads(3);
  const cv::Mat three = DrawMap(RowOfCubes(), kSmall);
  omp_set_num_threads(threads);
  EXPECT_EQ(cv::norm(one, three, cv::NORM_INF), 0);
}

TEST(MapPicture, OfNothingIsAFloor) {
  const cv::Mat3b picture = DrawMap({}, kSmall);
  EXPECT_NEAR(picture(50, 70)[1], 237, 15);
  MapScene only_a_wireframe;
  only_a_wireframe.objects = {
      MapSceneObject{"a", "chair", PoseAt({0, 0, 2}), {Vector3d::Zero(), Vector3d::UnitX()}, {}}};
  EXPECT_EQ(DrawMap(only_a_wireframe, kSmall).rows, 100);
}

TEST(MapPicture, DotsOfThePathAreEquallyFarApart) {
  const auto dots =
      PathDots({PoseAt({0, 0, 0}), PoseAt({0.25, 0, 0}), PoseAt({0.25, 0, 0}), PoseAt({0.25, 1, 0})}, 0.1);
  ASSERT_EQ(dots.size(), 13u);  // 1.25 m
  EXPECT_TRUE(dots[2].isApprox(Vector3d(0.2, 0, 0)));
  EXPECT_TRUE(dots[3].isApprox(Vector3d(0.25, 0.05, 0)));
  EXPECT_TRUE(dots[12].isApprox(Vector3d(0.25, 0.95, 0)));
  EXPECT_TRUE(PathDots({PoseAt({0, 0, 0})}, 0.1).empty());
}

}  // namespace
}  // namespace armature
