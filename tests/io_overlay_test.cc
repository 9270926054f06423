// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "drawing/overlay.h"

namespace armature {
namespace {

// One edge of 1 m along x, without modes.
CategoryModel Rod() {
  CategoryModel model;
  model.spec.name = "rod";
  model.spec.edge_names = {"rod"};
  model.mean = Eigen::VectorXd::Zero(6);
  model.mean(3) = 1;
  model.basis = Eigen::MatrixXd::Zero(6, 0);
  model.standard_deviations = Eigen::VectorXd::Zero(0);
  return model;
}

Camera SmallCamera() {
  Camera camera;
  camera.width = 200;
  camera.height = 100;
  camera.fx = camera.fy = 100;
  camera.cx = 100;
  camera.cy = 50;
  return camera;
}

FrameResult RodAt(const Eigen::Vector3d& position) {
  FrameResult frame;
  frame.observations.resize(1);
  frame.observations[0].detection.category = "rod";
  frame.observations[0].detection.box = {5, 80, 20, 15};
  frame.observations[0].estimate.status = EstimateStatus::kOk;
  frame.observations[0].estimate.T_camera_object.translation() = position;
  return frame;
}

int BrightnessAt(const cv::Mat& image, int x, int y) {
  const auto& pixel = image.at<cv::Vec3b>(y, x);
  return pixel[0] + pixel[1] + pixel[2];
}

TEST(Overlay, DrawsTheWireframeWhereItProjects) {
  const cv::Mat black(100, 200, CV_8UC3, cv::Scalar::all(0));
  const cv::Mat drawn = DrawOverlay(black, RodAt({0, 0, 2}), {Rod()}, SmallCamera());
  EXPECT_GT(BrightnessAt(drawn, 80, 50), 100);
  EXPECT_GT(BrightnessAt(drawn, 120, 50), 100);
  EXPECT_EQ(BrightnessAt(drawn, 140, 50), 0);
  EXPECT_EQ(BrightnessAt(drawn, 80, 30), 0);
}

TEST(Overlay, DoesNotDrawFailedEstimates) {
  const cv::Mat black(100, 200, CV_8UC3, cv::Scalar::all(0));
  FrameResult frame = RodAt({0, 0, 2});
  frame.observations[0].estimate.status = EstimateStatus::kDiverged;
  const cv::Mat drawn = DrawOverlay(black, frame, {Rod()}, SmallCamera());
  EXPECT_EQ(BrightnessAt(drawn, 120, 50), 0);
}

TEST(Overlay, LeavesTheInputAsItIsAndTakesGreyImages) {
  const cv::Mat grey(100, 200, CV_8UC1, cv::Scalar(100));
  const cv::Mat drawn = DrawOverlay(grey, RodAt({0, 0, 2}), {}, SmallCamera());
  EXPECT_EQ(drawn.type(), CV_8UC3);
  EXPECT_EQ(cv::countNonZero(grey != 100), 0);
}

TEST(Overlay, SurvivesWildNumbers) {
  const cv::Mat black(100, 200, CV_8UC3, cv::Scalar::all(0));
  FrameResult frame = RodAt({std::nan(""), 0, 2});
  frame.segments = {{{-1e12, 5}, {1e12, 7}}, {{std::nan(""), 0}, {1, 1}}};
  frame.observations[0].detection.box = {-1e9, -1e9, 2e9, 2e9};
  EXPECT_EQ(DrawOverlay(black, frame, {Rod()}, SmallCamera()).size(), black.size());
}

TEST(Overlay, CutsEdgesAtTheNearPlane) {
  const Wireframe rod = WireframeFromCoefficients(Rod(), Eigen::VectorXd());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(-1.5707963267948966, Eigen::Vector3d::UnitY()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0.01, 0, 0.3);  // along z, from -0.2 to 0.8 m
  const std::vector<Segment> segments = ProjectedEdges(rod, pose, SmallCamera());
  ASSERT_EQ(segments.size(), 1u);
  const double far = std::min(segments[0].p1.x(), segments[0].p2.x());
  const double near = std::max(segments[0].p1.x(), segments[0].p2.x());
  EXPECT_NEAR(far, 100 + 100 * 0.01 / 0.8, 1e-9);
  EXPECT_NEAR(near, 100 + 100 * 0.01 / 0.05, 1e-9);
  pose.translation().z() = -0.6;
  EXPECT_TRUE(ProjectedEdges(rod, pose, SmallCamera()).empty());
}

}  // namespace
}  // namespace armature
