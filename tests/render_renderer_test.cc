// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "datasets/render/renderer.h"
#include "render_test_scenes.h"

namespace armature {
namespace {

using Eigen::Vector3d;
using testing::LookingDown;
using testing::Placed;
using testing::SmallCamera;
using testing::Square;

const std::vector<Lamp> kLamps = {{{0, 0, 3}, {0.5, 0.5}, {1, 1, 1}, 1}};

cv::Mat3f RenderSquare(const Vector3d& camera_position) {
  const Renderer renderer({Placed(Square({0.9, 0.5, 0.2}), {0, 0, 0})}, kLamps, {});
  return renderer.Render(SmallCamera(), LookingDown(camera_position)).radiance;
}

TEST(Renderer, ProjectsAQuadToItsPixels) {
  // 20 pixels a unit at a distance of 2 units: 10 a unit; the square is 20 pixels wide around (19.5, 19.5).
  const cv::Mat3f picture = RenderSquare({0, 0, 2});
  for (int i = 0; i < 40; ++i) {
    const bool inside = i >= 10 && i <= 29;
    EXPECT_EQ(picture(20, i)[1] > 0, inside) << i;
    EXPECT_EQ(picture(i, 20)[1] > 0, inside) << i;
  }
}

TEST(Renderer, AHalfCoveredPixelIsHalfAsBright) {
  // The camera is moved by half a pixel to the left: so is the square to the right.
  const cv::Mat3f picture = RenderSquare({-0.05, 0, 2});
  EXPECT_NEAR(picture(20, 10)[1] / picture(20, 11)[1], 0.5, 0.03);
  EXPECT_NEAR(picture(20, 30)[1] / picture(20, 29)[1], 0.5, 0.03);
  EXPECT_EQ(picture(20, 31)[1], 0);
}

TEST(Renderer, ChannelsAreBlueGreenRed) {
  const cv::Vec3f pixel = RenderSquare({0, 0, 2})(20, 20);
  EXPECT_LT(pixel[0], pixel[1]);
  EXPECT_LT(pixel[1], pixel[2]);
}

TEST(Renderer, ShowsLampsAsBrightRectangles) {
  const Renderer renderer({Placed(Square(), {0, 0, 0})}, kLamps, {});
  Eigen::Isometry3d looking_up = Eigen::Isometry3d::Identity();
  looking_up.translation().z() = 1;
  const cv::Mat3f picture = renderer.Render(SmallCamera(), looking_up).radiance;  // 10 pixels a metre there
  EXPECT_GT(picture(20, 20)[1], 1);
  EXPECT_GT(picture(20, 17)[1], 1);
  EXPECT_EQ(picture(20, 15)[1], 0);
}

TEST(Renderer, APolishedSurfaceMirrorsWhatIsBesideIt) {
  const auto picture_with_gloss = [](double gloss) {
    Part floor = Square({0.1, 0.1, 0.1});
    floor.material.gloss = gloss;
    Part wall = Block(Vector3d(-1, 1, 0), Vector3d(1, 1.1, 1), {});
    wall.material.colour = {0.9, 0.1, 0.1};
    const Renderer renderer({Placed(floor, {0, 0, 0}), Placed(wall, {0, 0, 0})}, kLamps, {});
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();  // at 0.2 m height, looking along y
    T_world_camera.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    T_world_camera.translation() = Vector3d(0, -0.9, 0.2);
    return renderer.Render(SmallCamera(), T_world_camera).radiance;
  };
  const cv::Vec3f matt = picture_with_gloss(0)(23, 20), polished = picture_with_gloss(1)(23, 20);
  EXPECT_GT(polished[2] - polished[1], 3 * (matt[2] - matt[1]) + 0.01f);
}

TEST(Renderer, GivesTheSamePictureEachTime) {
  EXPECT_EQ(cv::norm(RenderSquare({0.1, 0.2, 1.5}), RenderSquare({0.1, 0.2, 1.5}), cv::NORM_INF), 0);
}

TEST(Renderer, PutsTheRaysOfTheCallersMeshesAtHisDisposal) {
  const Renderer renderer({Placed(Square(), {0, 0, 0}, 4)}, kLamps, {});
  EXPECT_EQ(renderer.rays().Nearest({0, 0, 1}, -Vector3d::UnitZ()).object, 4);
}

}  // namespace
}  // namespace armature
