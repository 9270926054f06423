// SPDX-License-Identifier: BSD-3-Clause
// Rooms, and what lies about in them.
#include <gtest/gtest.h>

#include "datasets/scene/clutter.h"
#include "datasets/scene/room_mesh.h"
#include "datasets/scene/scattered_clutter.h"
#include "datasets/scene/solid.h"
#include "datasets/scene/support.h"
#include "datasets/scene/walls.h"
#include "support/block_collection.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// A table with a laptop on it and a chair, in a room of 6 x 5 m.
Scene SmallScene() {
  Scene scene;
  scene.room.size = {6, 5, 2.6};
  scene.lamps.resize(1);
  scene.lamps[0].centre = {0, 0, 2.4};
  scene.path.length = 2, scene.path.width = 1;
  const std::vector<CadInstance> collection = testing::BlockCollection();
  Isometry3d place = Isometry3d::Identity();
  place.translation() = Vector3d(0, 2, 0);
  scene.objects.push_back({"table", collection[2], StandingOn(place, collection[2])});
  place.translation() = Vector3d(1.5, 2, 0);
  scene.objects.push_back({"chair", collection[0], StandingOn(place, collection[0])});
  scene.objects.push_back({"laptop", collection[4], StandingOn(FindTop(scene.objects[0]), collection[4])});
  return scene;
}

Eigen::AlignedBox3d WorldBox(const PlacedMesh& placed) {
  Eigen::AlignedBox3d box;
  for (const Part& part : placed.mesh.parts) {
    for (const Quad& quad : part.quads) {
      for (const Vector3d& corner : quad.corners) box.extend(placed.T_world_mesh * corner);
    }
  }
  return box;
}

std::vector<Vector3d> AllCorners(const std::vector<PlacedMesh>& meshes) {
  std::vector<Vector3d> corners;
  for (const PlacedMesh& placed : meshes) {
    for (const Part& part : placed.mesh.parts) {
      for (const Quad& quad : part.quads) {
        for (const Vector3d& corner : quad.corners) corners.push_back(placed.T_world_mesh * corner);
      }
    }
  }
  return corners;
}

TEST(SceneMeshes, NumbersTheObjectsInTheirOrder) {
  const Scene scene = SmallScene();
  const std::vector<PlacedMesh> meshes = SceneMeshes(scene);
  for (size_t i = 0; i < meshes.size(); ++i) {
    EXPECT_EQ(meshes[i].object, i < 3 ? static_cast<int>(i) + 1 : kRoom);
  }
  EXPECT_TRUE(meshes[2].T_world_mesh.isApprox(scene.objects[2].T_world_object));
  EXPECT_NEAR(WorldBox(meshes[2]).min().z(), 0.74, 1e-9);  // the laptop stands on the table
  EXPECT_NEAR(WorldBox(meshes[0]).min().z(), 0, 1e-9);
}

TEST(SceneMeshes, FillTheRoomAndNothingElse) {
  Eigen::AlignedBox3d box;
  for (const PlacedMesh& mesh : SceneMeshes(SmallScene())) box.extend(WorldBox(mesh));
  EXPECT_NEAR(box.min().x(), -3, 1e-9);
  EXPECT_NEAR(box.max().x(), 3, 1e-9);
  EXPECT_NEAR(box.min().y(), -2.5, 1e-9);
  EXPECT_NEAR(box.max().y(), 2.5, 1e-9);
  EXPECT_NEAR(box.min().z(), 0, 1e-9);
  EXPECT_NEAR(box.max().z(), 2.6, 1e-9);
}

// The first six sheets of the room's shell: their areas are those of the room's sides, and all face its
// middle.
TEST(SceneMeshes, CloseTheRoom) {
  const Scene scene = SmallScene();
  const Mesh shell = SceneMeshes(scene)[3].mesh;
  ASSERT_EQ(shell.parts.size(), 6u);
  double area = 0;
  for (const Part& part : shell.parts) {
    const auto& c = part.quads.at(0).corners;
    const Vector3d normal = (c[1] - c[0]).cross(c[2] - c[1]);
    area += normal.norm();
    EXPECT_GT(normal.dot(Vector3d(0, 0, 1.3) - c[0]), 0);
    EXPECT_TRUE((part.T_mesh_part.linear() * Vector3d::UnitZ()).isApprox(normal.normalized(), 1e-9));
  }
  EXPECT_NEAR(area, 2 * (6 * 5 + 6 * 2.6 + 5 * 2.6), 1e-9);
}

TEST(SceneMeshes, AreTheSameForTheSameSeed) {
  Scene scene = SmallScene();
  const std::vector<Vector3d> first = AllCorners(SceneMeshes(scene));
  EXPECT_EQ(first, AllCorners(SceneMeshes(scene)));
  scene.seed = 2;
  EXPECT_NE(first, AllCorners(SceneMeshes(scene)));
}

TEST(WallDecoration, HangsPicturesInsideOfTheWalls) {
  Room room = SmallScene().room;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    room.pictures = 0;
    const size_t bare = WallDecoration(room, random).parts.size();
    Random again(seed);
    room.pictures = 5;
    const Mesh mesh = WallDecoration(room, again);
    EXPECT_EQ(mesh.parts.size(), bare + 5 * 6);  // four strips of the frame, passe-partout, painting
    const Eigen::AlignedBox3d box = BoundingBox(mesh);
    EXPECT_LE(box.sizes().x(), 6 + 1e-9);
    EXPECT_LE(box.sizes().y(), 5 + 1e-9);
    EXPECT_LT(box.max().z(), 2.6);
  }
}

TEST(Clutter, StaysWithinItsSize) {
  const Vector3d size(0.3, 0.2, 0.25);
  for (const std::string& shape : ClutterShapes()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Random random(seed);
      const Eigen::AlignedBox3d box = BoundingBox(ClutterMesh(shape, size, {0.5, 0.5, 0.5}, random));
      EXPECT_LE((box.max() - Vector3d(0.15, 0.1, 0.25)).maxCoeff(), 1e-9) << shape;
      EXPECT_GE((box.min() + Vector3d(0.15, 0.1, 0)).minCoeff(), -1e-9) << shape;
      EXPECT_NEAR(box.sizes().z(), 0.25, 1e-9) << shape;
    }
  }
}

TEST(ScatteredClutter, OverlapsNothing) {
  Scene scene = SmallScene();
  for (scene.seed = 1; scene.seed < 12; ++scene.seed) {
    std::vector<OrientedBox> boxes;
    for (const SceneObject& object : scene.objects) {
      boxes.push_back({object.T_world_object, object.instance.size});
    }
    const std::vector<ClutterPiece> pieces = ScatteredClutter(scene);
    EXPECT_GE(pieces.size(), 8u);
    for (const ClutterPiece& piece : pieces) {
      const OrientedBox box = MakeSolid(piece.mesh, piece.T_world_mesh).around;
      for (const OrientedBox& other : boxes) EXPECT_LT(IntersectionVolume(box, other), 1e-9);
      boxes.push_back(box);
    }
  }
}

TEST(ScatteredClutter, StandsOnTheFloorAndOnTablesOnly) {
  Scene scene = SmallScene();
  scene.room.clutter = 6, scene.room.table_clutter = 2;
  int on_table = 0;
  for (const ClutterPiece& piece : ScatteredClutter(scene)) {
    const Eigen::AlignedBox3d box = WorldBox({piece.mesh, piece.T_world_mesh});
    if (box.min().z() > 1e-9) {
      EXPECT_NEAR(box.min().z(), 0.74, 1e-9);
      EXPECT_LT(std::abs(box.center().x()), 0.65);
      EXPECT_LT(std::abs(box.center().y() - 2), 0.375);
      ++on_table;
    }
    EXPECT_LT(box.max().x(), 3);
    EXPECT_LT(box.max().y(), 2.5);
    EXPECT_GT(box.min().x(), -3);
    EXPECT_GT(box.min().y(), -2.5);
  }
  EXPECT_EQ(on_table, 2);
}

}  // namespace
}  // namespace armature
