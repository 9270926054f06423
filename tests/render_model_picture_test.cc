// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "drawing/model_picture.h"
#include "geometry/mesh_shapes.h"

namespace armature {
namespace {

// The rectangle around all that is not white.
cv::Rect Drawn(const cv::Mat& picture) {
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return cv::boundingRect(grey < 250);
}

TEST(ModelPicture, IsCentredAndTheLargestFits) {
  const TriangleMesh wide = BarMesh({-0.5, 0, 0}, {0.5, 0, 0}, 0.1);
  const TriangleMesh half = BarMesh({-0.25, 0, 0}, {0.25, 0, 0}, 0.1);
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();
  T_camera_object.translation() = Eigen::Vector3d(0.4, -0.2, 3);  // off the axis
  const std::vector<cv::Mat> pictures =
      DrawModels({wide, half}, T_camera_object, {.width = 100, .height = 80, .samples = 4});
  ASSERT_EQ(pictures.size(), 2u);
  const cv::Rect first = Drawn(pictures[0]), second = Drawn(pictures[1]);
  EXPECT_EQ(pictures[0].size(), cv::Size(100, 80));
  EXPECT_NEAR(first.width, 94, 3);
  EXPECT_NEAR(second.width, 47, 3);  // to the same scale
  for (const cv::Rect& drawn : {first, second}) {
    EXPECT_NEAR(drawn.x + drawn.width / 2.0, 50, 3);
    EXPECT_NEAR(drawn.y + drawn.height / 2.0, 40, 3);
  }
}

TEST(ModelPicture, AModelAroundTheCameraIsSeenFromOutside) {
  const TriangleMesh bar = BarMesh({-0.5, 0, 0}, {0.5, 0, 0}, 0.1);
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();
  T_camera_object.translation().z() = 0.1;
  const cv::Mat picture =
      DrawModels({bar}, T_camera_object, {.width = 60, .height = 40, .samples = 2}).front();
  EXPECT_NEAR(Drawn(picture).width, 56, 4);
}

}  // namespace
}  // namespace armature
