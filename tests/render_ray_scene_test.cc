// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "drawing/ray_scene.h"
#include "render_test_scenes.h"

namespace armature {
namespace {

using Eigen::Vector3d;
using testing::Placed;
using testing::Square;

// Squares at heights 0 and 1 (object 1, moved by 0.5 along x) and 3 (object 2).
RayScene ThreeSquares() {
  return RayScene(
      {Placed(Square(), {0, 0, 0}), Placed(Square(), {0.5, 0, 1}, 1), Placed(Square(), {0, 0, 3}, 2)});
}

TEST(RayScene, FindsTheNearestQuadItsDistanceAndPlace) {
  const RayHit hit = ThreeSquares().Nearest({0, 0.5, 2.25}, -Vector3d::UnitZ());
  EXPECT_EQ(hit.mesh, 1);
  EXPECT_EQ(hit.part, 0);
  EXPECT_EQ(hit.quad, 0);
  EXPECT_EQ(hit.object, 1);
  EXPECT_NEAR(hit.distance, 1.25, 1e-6);
  EXPECT_NEAR(hit.u, 0.25, 1e-6);  // x from -0.5 to 1.5
  EXPECT_NEAR(hit.v, 0.75, 1e-6);  // y from -1 to 1
}

TEST(RayScene, SeesQuadsFromBehind) {
  const RayHit hit = ThreeSquares().Nearest({0, 0.5, 2.25}, Vector3d::UnitZ());
  EXPECT_EQ(hit.object, 2);
  EXPECT_NEAR(hit.distance, 0.75, 1e-6);
  EXPECT_NEAR(hit.u, 0.5, 1e-6);
  EXPECT_NEAR(hit.v, 0.75, 1e-6);
}

TEST(RayScene, MeetsNothingBesideEverything) {
  EXPECT_EQ(ThreeSquares().Nearest({5, 0, 2}, -Vector3d::UnitZ()).mesh, -1);
}

TEST(RayScene, TellsPartsAndQuadsApart) {
  const Part block = Block(Vector3d(-1, -1, -1), Vector3d(1, 1, 1), {});
  PlacedMesh placed = Placed(block, {0, 0, 0});
  placed.mesh.parts.push_back(Block(Vector3d(2, -1, -1), Vector3d(4, 1, 1), {}));
  const RayHit hit = RayScene({placed}).Nearest({3, 0, 5}, -Vector3d::UnitZ());
  ASSERT_EQ(hit.part, 1);
  for (const Vector3d& corner : placed.mesh.parts[1].quads[static_cast<size_t>(hit.quad)].corners) {
    EXPECT_EQ(corner.z(), 1);
  }
}

TEST(RayScene, MeetsTriangles) {
  Part triangle = Square();
  triangle.quads[0].corners[3] = triangle.quads[0].corners[2];
  const RayScene scene({Placed(triangle, {0, 0, 0})});
  EXPECT_EQ(scene.Nearest({0.5, -0.5, 1}, -Vector3d::UnitZ()).mesh, 0);
  EXPECT_EQ(scene.Nearest({-0.5, 0.5, 1}, -Vector3d::UnitZ()).mesh, -1);
}

TEST(RayScene, LooksForOneObjectThroughAllOthers) {
  const RayScene scene = ThreeSquares();
  EXPECT_NEAR(scene.HitNearestOfObject(2, {0, 0, -2}, Vector3d::UnitZ()).distance, 5, 1e-6);
  EXPECT_EQ(scene.HitNearestOfObject(2, {0, 0, -2}, Vector3d::UnitZ()).mesh, 2);
  EXPECT_EQ(scene.HitNearestOfObject(1, {0, 0, 2}, Vector3d::UnitZ()).mesh, -1);
  EXPECT_EQ(scene.HitNearestOfObject(7, {0, 0, 2}, Vector3d::UnitZ()).mesh, -1);
}

TEST(RayScene, IsBlockedOnlyByWhatIsBetween) {
  const RayScene scene = ThreeSquares();
  EXPECT_TRUE(scene.IsBlocked({0, 0, 0.5}, {0, 0, 2}));
  EXPECT_FALSE(scene.IsBlocked({0, 0, 1.5}, {0, 0, 2.5}));
  EXPECT_FALSE(scene.IsBlocked({0, 0, 1}, {0, 0, 3}));  // both ends are on surfaces
}

TEST(RayScene, AnswersManyRaysAsEachOfThem) {
  const RayScene scene = ThreeSquares();
  std::vector<Vector3d> directions, ends;
  for (int i = 0; i < 19; ++i) {
    directions.push_back(Vector3d(0.1 * i - 0.9, 0.05, -1).normalized());
    ends.emplace_back(0.2 * i - 1.9, 0, 0.5);
  }
  const Vector3d origin(0, 0, 2);
  std::vector<RayHit> hits(directions.size());
  std::vector<char> blocked(ends.size());
  scene.Nearest(origin, directions, hits);
  scene.AreBlocked(origin, ends, blocked);
  for (size_t i = 0; i < hits.size(); ++i) {
    const RayHit hit = scene.Nearest(origin, directions[i]);
    EXPECT_EQ(hits[i].mesh, hit.mesh);
    EXPECT_NEAR(hits[i].distance, hit.distance, 1e-5);
    EXPECT_EQ(blocked[i] != 0, scene.IsBlocked(origin, ends[i]));
  }
}

}  // namespace
}  // namespace armature
