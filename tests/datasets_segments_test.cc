// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "datasets/cad/solids.h"
#include "datasets/simulation/segments.h"
#include "datasets/simulation/surface_lines.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

const Camera kSmallCamera{640, 480, 500, 500, 319.5, 239.5, {}};

// Nothing is missed, broken or moved, and nothing is drawn on the faces.
SegmentNoise Perfect() {
  SegmentNoise noise;
  noise.patterns_per_m2 = 0;
  noise.found_px = 1e-6;
  noise.most = 1e9;
  noise.break_px = 1e9;
  noise.end_px = noise.across_px = noise.own_px = 0;
  return noise;
}

std::vector<PlacedMesh> Of(const Part& part, int object = 1) {
  return {{Mesh{{part}}, Isometry3d::Identity(), object}};
}

std::vector<Segment> See(const std::vector<PlacedMesh>& meshes, const SegmentNoise& noise,
                         std::uint64_t seed = 1) {
  const auto lines = FindSurfaceLines(meshes, noise.patterns_per_m2, 7);
  return SimulateSegments(lines, RayScene(meshes), kSmallCamera, Isometry3d::Identity(), noise, seed);
}

double LongestOf(const std::vector<Segment>& segments) {
  return segments.empty() ? 0 : segments.front().length();
}

TEST(SurfaceLines, ABlockHasTwelveSharpEdges) {
  const auto lines = FindSurfaceLines(Of(Block(Vector3d(0, 0, 0), {1, 2, 3}, {})), 0, 1);
  ASSERT_EQ(lines.size(), 12u);
  for (const SurfaceLine& line : lines) {
    EXPECT_TRUE(line.is_sharp);
    EXPECT_NEAR(line.normal1.dot(line.normal2), 0, 1e-12);
  }
}

TEST(SurfaceLines, AManySidedCylinderHasTwoSharpRimsAndOutlines) {
  const auto lines = FindSurfaceLines(Of(Cylinder({0, 0, 0}, {0, 0, 1}, 0.2, 0.2, 24, {})), 0, 1);
  int sharp = 0, outlines = 0;
  for (const SurfaceLine& line : lines) (line.is_sharp ? sharp : outlines) += 1;
  EXPECT_EQ(sharp, 48);
  EXPECT_EQ(outlines, 24);
}

TEST(SurfaceLines, PatternsAreAsManyAsTheFacesAreLarge) {
  const auto lines =
      FindSurfaceLines(Of(Block(Vector3d(0, 0, 0), {10, 10, 10}, {.texture = Texture::kWood})), 2, 1);
  EXPECT_NEAR(static_cast<double>(lines.size()), 12 + 2 * 600, 6);
}

// A cube of 1 m whose front is 2 m before the camera, seen straight on: only the front's edges, of 250 px.
TEST(SimulatedSegments, OfACubeSeenStraightOnAreTheSquareOfItsFront) {
  const auto segments = See(Of(Block(Vector3d(-0.5, -0.5, 2), {0.5, 0.5, 3}, {})), Perfect());
  ASSERT_EQ(segments.size(), 4u);
  for (const Segment& segment : segments) {
    EXPECT_NEAR(segment.length(), 250, 1e-9);
    EXPECT_NEAR((segment.middle() - Eigen::Vector2d(319.5, 239.5)).norm(), 125, 1e-9);
  }
}

TEST(SimulatedSegments, AreMissingWhereSomethingStandsBefore) {
  std::vector<PlacedMesh> meshes = Of(Block(Vector3d(-0.5, -0.5, 2), {0.5, 0.5, 3}, {}));
  meshes.push_back({Mesh{{Block(Vector3d(-0.4, -0.6, 1), {0.4, 0.6, 1.01}, {})}}, Isometry3d::Identity(), 2});
  const auto segments = See(meshes, Perfect());
  // All of the cube is behind the board, whose upper and lower edge are outside of the image.
  EXPECT_EQ(segments.size(), 2u);
  EXPECT_NEAR(LongestOf(segments), 480, 1);
}

TEST(SimulatedSegments, StayInTheImageAndBeforeTheCamera) {
  const auto segments = See(Of(Block(Vector3d(-3, 0.5, -2), {3, 0.6, 4}, {})), Perfect());
  ASSERT_FALSE(segments.empty());
  for (const Segment& segment : segments) {
    for (const Eigen::Vector2d& end : {segment.p1, segment.p2}) {
      EXPECT_GE(end.x(), -0.5 - 1e-9);
      EXPECT_LE(end.x(), 639.5 + 1e-9);
      EXPECT_LE(end.y(), 479.5 + 1e-9);
    }
  }
}

TEST(SimulatedSegments, ShortAndFaintLinesAreMissedMoreOften) {
  std::vector<PlacedMesh> meshes;
  for (int i = 0; i < 200; ++i) {
    const Vector3d low(-2 + 0.15 * (i % 20), -1 + 0.2 * (i / 20), 4);
    meshes.push_back(
        {Mesh{{Block(low, low + Vector3d(0.12, 0.16, 0.1), {})}}, Isometry3d::Identity(), i + 1});
  }
  SegmentNoise noise = Perfect();
  const size_t all = See(meshes, noise).size();
  noise.found_px = 15;  // about their length
  const size_t half = See(meshes, noise).size();
  EXPECT_LT(half, 0.75 * static_cast<double>(all));
  EXPECT_GT(half, 0.25 * static_cast<double>(all));
}

TEST(SimulatedSegments, AreTheSameForTheSameSeedAndOthersForAnother) {
  const auto meshes = Of(Block(Vector3d(-0.5, -0.5, 2), {0.5, 0.5, 3}, {}));
  const auto a = See(meshes, {}, 1), b = See(meshes, {}, 1), c = See(meshes, {}, 2);
  ASSERT_FALSE(a.empty());
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].p1, b[i].p1);
  EXPECT_TRUE(c.empty() || c.front().p1 != a.front().p1);
}

TEST(SeeObjects, NumbersThePixelsOfAnObject) {
  const RayScene rays(Of(Block(Vector3d(-0.5, -0.5, 2), {0.5, 0.5, 3}, {}), 3));
  const cv::Mat1i objects = SeeObjects(rays, kSmallCamera, Isometry3d::Identity());
  EXPECT_EQ(objects(240, 320), 3);
  EXPECT_EQ(objects(240, 180), kRoom);
  EXPECT_NEAR(cv::countNonZero(objects), 250 * 250, 2 * 250 * 4);
}

}  // namespace
}  // namespace armature
