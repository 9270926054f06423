// SPDX-License-Identifier: BSD-3-Clause
// Pixels worked out by hand, from the conventions of the design alone: the views of other tests are made with
// the code that they test.
#include <gtest/gtest.h>

#include "association/projection.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

// fx and fy, cx and cy differ, so that none can stand for the other.
const Camera kHandCamera{640, 480, 500, 400, 320, 240, {}};
const Box kWholeImage{0, 0, 639, 479};

// Upright, its front towards a level camera, its centre two metres ahead: camera x = object x, camera y =
// -object y, camera z = 2 - object z.
Eigen::Isometry3d TwoMetresAhead() {
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();
  T_camera_object.matrix() << 1, 0, 0, 0,  //
      0, -1, 0, 0,                         //
      0, 0, -1, 2,                         //
      0, 0, 0, 1;
  return T_camera_object;
}

ProjectedEdge ProjectOneEdge(const Eigen::Vector3d& midpoint, const Eigen::Vector3d& direction) {
  ProjectedWireframe projected;
  ProjectEdges(kHandCamera, {midpoint, direction}, TwoMetresAhead(), kWholeImage, projected);
  return projected.edges.at(0);
}

void ExpectPixel(const Eigen::Vector2d& pixel, double u, double v) {
  EXPECT_NEAR(pixel.x(), u, 1e-9);
  EXPECT_NEAR(pixel.y(), v, 1e-9);
}

TEST(PixelsByHand, OfAPoint) {
  // u = 500 * 0.2 / 2 + 320 = 370, v = 400 * -0.1 / 2 + 240 = 220
  ExpectPixel(kHandCamera.Project({0.2, -0.1, 2}), 370, 220);
  ExpectPixel(kHandCamera.Project({0, 0, 7}), 320, 240);
  // The other way round: (370 - 320) / 500 = 0.1, (220 - 240) / 400 = -0.05
  EXPECT_LT((kHandCamera.Ray({370, 220}) - Eigen::Vector3d(0.1, -0.05, 1)).norm(), 1e-12);
}

// A cube of one metre around the origin: its front is at depth 2 - 0.5 = 1.5, its rear at 2.5.
TEST(PixelsByHand, OfTheEdgesOfACube) {
  // The front's top, from (-0.5, 0.5, 0.5) to (0.5, 0.5, 0.5):
  // u = 500 * -+0.5 / 1.5 + 320 = 320 -+ 166.666..., v = 400 * -0.5 / 1.5 + 240 = 106.666...
  const ProjectedEdge front = ProjectOneEdge({0, 0.5, 0.5}, {1, 0, 0});
  ExpectPixel(front.line.p1, 320 - 500.0 / 3, 320.0 / 3);
  ExpectPixel(front.line.p2, 320 + 500.0 / 3, 320.0 / 3);
  ExpectPixel(front.direction, 1, 0);
  EXPECT_NEAR(front.length, 1000.0 / 3, 1e-9);
  EXPECT_NEAR(front.s1, -0.5, 1e-12);
  EXPECT_NEAR(front.s2, 0.5, 1e-12);
  EXPECT_NEAR(front.inverse_z1, 1 / 1.5, 1e-12);

  // The rear's right side, from below (0.5, -0.5, -0.5) to (0.5, 0.5, -0.5):
  // u = 500 * 0.5 / 2.5 + 320 = 420, v = 400 * +-0.5 / 2.5 + 240 = 320 below and 160 above
  const ProjectedEdge rear = ProjectOneEdge({0.5, 0, -0.5}, {0, 1, 0});
  ExpectPixel(rear.line.p1, 420, 320);
  ExpectPixel(rear.line.p2, 420, 160);
  ExpectPixel(rear.direction, 0, -1);

  // The top's right side, from the front (0.5, 0.5, 0.5) to the rear (0.5, 0.5, -0.5): from
  // u = 500 * 0.5 / 1.5 + 320, v = 400 * -0.5 / 1.5 + 240 to u = 420, v = 160
  const ProjectedEdge side = ProjectOneEdge({0.5, 0.5, 0}, {0, 0, -1});
  ExpectPixel(side.line.p1, 320 + 500.0 / 3, 320.0 / 3);
  ExpectPixel(side.line.p2, 420, 160);
  EXPECT_NEAR(side.inverse_z1, 1 / 1.5, 1e-12);
  EXPECT_NEAR(side.inverse_z2, 1 / 2.5, 1e-12);
}

// From x = -1.5 to x = 0.5 at depth 2: u = 500 * -1.5 / 2 + 320 = -55, cut at u = 0, and u = 500 * 0.5 / 2 +
// 320 = 445. u = 0 is x = -320 * 2 / 500 = -1.28, on the edge s = (-1.28 + 0.5) / 2 = -0.39.
TEST(PixelsByHand, OfAnEdgeThatLeavesTheImage) {
  const ProjectedEdge edge = ProjectOneEdge({-0.5, 0, 0}, {2, 0, 0});
  ExpectPixel(edge.line.p1, 0, 240);
  ExpectPixel(edge.line.p2, 445, 240);
  EXPECT_NEAR(edge.s1, -0.39, 1e-9);
  EXPECT_NEAR(edge.s2, 0.5, 1e-9);
}

TEST(PixelsByHand, AtViewpointZeroTheFrontIsTowardsTheCamera) {
  EXPECT_LT((RotationFromViewpoint({}, {0, 0, 2}) - TwoMetresAhead().linear()).norm(), 1e-12);
}

// Azimuth 90 degrees, elevation asin 0.6, four metres away: the camera is at 4 * (cos e sin a, sin e, cos e
// cos a) = (3.2, 2.4, 0) in the object's frame. It looks along (-0.8, -0.6, 0), its down is (0.6, -0.8, 0)
// and its right, down x forward, (0, 0, -1): the object's front is on the left.
TEST(PixelsByHand, OfAPointSeenFromTheObjectsRightAndAbove) {
  Eigen::Matrix3d R;
  R << 0, 0, -1,     //
      0.6, -0.8, 0,  //
      -0.8, -0.6, 0;
  const Viewpoint viewpoint{.azimuth = std::acos(0.0), .elevation = std::asin(0.6), .tilt = 0};
  EXPECT_LT((RotationFromViewpoint(viewpoint, {0, 0, 4}) - R).norm(), 1e-12);
  const Viewpoint back = ViewpointFromRotation(R, {0, 0, 4});
  EXPECT_NEAR(back.azimuth, std::acos(0.0), 1e-12);
  EXPECT_NEAR(back.elevation, std::asin(0.6), 1e-12);
  EXPECT_NEAR(back.tilt, 0, 1e-12);
  // (0.5, 0.5, 0.6) is at x = -0.6, y = 0.3 - 0.4 = -0.1, z = -0.4 - 0.3 + 4 = 3.3 before the camera:
  // u = 500 * -0.6 / 3.3 + 320 = 229.0909..., v = 400 * -0.1 / 3.3 + 240 = 227.8787...
  const Eigen::Vector3d point = RotationFromViewpoint(viewpoint, {0, 0, 4}) * Eigen::Vector3d(0.5, 0.5, 0.6);
  ExpectPixel(kHandCamera.Project(point + Eigen::Vector3d(0, 0, 4)), 2520.0 / 11, 7520.0 / 33);
}

// A quarter turn in the image plane takes the image's right to its bottom: what was up is at the right.
TEST(PixelsByHand, TiltIsClockwise) {
  const Eigen::Matrix3d R = RotationFromViewpoint({.tilt = std::acos(0.0)}, {0, 0, 2});
  EXPECT_LT((R * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

// Off the axis the viewpoint is about the ray: seen along (3, 0, 4) / 5, level and from the front, the object
// is turned by the ray's own angle about the camera's y axis.
TEST(PixelsByHand, AViewpointIsAboutTheRay) {
  Eigen::Matrix3d R;
  R << 0.8, 0, -0.6,  //
      0, -1, 0,       //
      -0.6, 0, -0.8;
  EXPECT_LT((RotationFromViewpoint({}, {3, 0, 4}) - R).norm(), 1e-12);
}

}  // namespace
}  // namespace armature
