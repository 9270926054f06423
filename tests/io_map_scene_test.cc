// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>

#include "drawing/map_scene.h"
#include "geometry/mesh_shapes.h"

namespace armature {
namespace {

using Eigen::Vector3d;

Eigen::Isometry3d At(double x, double y, double z) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Vector3d(x, y, z);
  return T;
}

// A cube of 1 m with one edge along x, 5 m ahead.
MapSceneObject CubeOf(const std::string& category) {
  MapSceneObject object{
      "cube", category, At(0, 0, 5), {}, BoxMesh(Vector3d::Zero(), Eigen::Matrix3d::Identity() / 2)};
  object.wireframe.midpoints = Vector3d(0, 0.5, 0.5);
  object.wireframe.directions = Vector3d(1, 0, 0);
  return object;
}

// The vertices of all triangles of this colour.
Eigen::AlignedBox3d ExtentOf(const TriangleMesh& mesh, const ColourBytes& colour) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index i = 0; i < mesh.size(); ++i) {
    if (mesh.colours.col(i) != colour) continue;
    for (const int v : mesh.triangles.col(i)) box.extend(mesh.vertices.col(v));
  }
  return box;
}

TEST(MapSceneMesh, HasCadModelsAndWireframesWhereTheObjectsAre) {
  MapScene scene;
  scene.objects = {CubeOf("chair")};
  const TriangleMesh mesh = SceneMesh(scene, {.wireframe_thickness = 0.02});
  EXPECT_EQ(mesh.size(), 12 + 12);
  const Eigen::AlignedBox3d cad = ExtentOf(mesh, ObjectColour(scene, 0));
  EXPECT_TRUE(cad.min().isApprox(Vector3d(-0.5, -0.5, 4.5)));
  EXPECT_TRUE(cad.max().isApprox(Vector3d(0.5, 0.5, 5.5)));
  const Eigen::AlignedBox3d bar = ExtentOf(mesh, WireframeColour(scene, 0));
  EXPECT_TRUE(bar.min().isApprox(Vector3d(-0.5, 0.49, 5.49)));
  EXPECT_TRUE(bar.max().isApprox(Vector3d(0.5, 0.51, 5.51)));
}

TEST(MapSceneMesh, CamerasAndPathAreSpaced) {
  MapScene scene;
  for (int i = 0; i <= 100; ++i) scene.T_world_camera.push_back(At(0.01 * i, 0, 0));
  const TriangleMesh mesh =
      SceneMesh(scene, {.path_thickness = 0.02, .camera_depth = 0.1, .camera_spacing = 0.24});
  const Eigen::Index cameras = (mesh.colours.colwise() - kCameraColour).cwiseEqual(0).colwise().all().count();
  EXPECT_EQ(cameras, 5 * 8 * 12);
  const Eigen::AlignedBox3d path = ExtentOf(mesh, kPathColour);
  EXPECT_NEAR(path.min().x(), 0, 1e-9);
  EXPECT_NEAR(path.max().x(), 1, 1e-9);
  EXPECT_NEAR(path.sizes().y(), 0.02, 1e-9);
  EXPECT_NEAR(ExtentOf(mesh, kCameraColour).max().z(), 0.1, 0.01);  // the cameras look along +z
}

TEST(MapSceneMesh, ACategoryHasAColourAndAnObjectItsShade) {
  MapScene scene;
  scene.objects = {CubeOf("chair"), CubeOf("table"), CubeOf("chair")};
  EXPECT_NE(ObjectColour(scene, 0), ObjectColour(scene, 1));
  EXPECT_NE(ObjectColour(scene, 0), ObjectColour(scene, 2));
  const auto direction = [&](size_t i) {
    return Vector3d(ObjectColour(scene, i).cast<double>().normalized());
  };
  EXPECT_GT(direction(0).dot(direction(2)), 0.999);
  EXPECT_LT(direction(0).dot(direction(1)), 0.97);
}

TEST(MapSceneMesh, WhatIsNotThereIsLeftOut) {
  EXPECT_EQ(SceneMesh({}).size(), 0);
  MapScene scene;
  scene.objects = {MapSceneObject{"a", "chair", {}, {}, {}}};
  scene.objects[0].wireframe = {Vector3d::Zero(), Vector3d::Zero()};  // an edge without length
  scene.T_world_camera = {At(0, 0, 0), At(0, 0, 0)};
  EXPECT_EQ(SceneMesh(scene).size(), 8 * 12);
}

TEST(MeshShapes, ABallIsRoundAndClosed) {
  const TriangleMesh ball = BallMesh({1, 2, 3}, 2);
  const Eigen::Matrix3Xd spokes = ball.vertices.colwise() - Vector3d(1, 2, 3);
  EXPECT_NEAR((spokes.colwise().norm().array() - 2).abs().maxCoeff(), 0, 1e-12);
  EXPECT_EQ(ball.size(), 320);
  EXPECT_EQ(ball.vertices.cols(), 162);  // Euler: V - E + F = 2, E = 3/2 F
  double volume = 0;
  for (const auto& t : ball.triangles.colwise()) {
    volume += std::abs(spokes.col(t[0]).dot(spokes.col(t[1]).cross(spokes.col(t[2])))) / 6;
  }
  EXPECT_NEAR(volume, 4. / 3 * std::numbers::pi * 8, 1.5);
}

TEST(MeshShapes, MeshesAreMovedAndJoined) {
  const TriangleMesh box = BoxMesh(Vector3d::Zero(), Eigen::Matrix3d::Identity());
  const Eigen::Affine3d T = Eigen::Translation3d(1, 0, 0) * Eigen::Scaling(2.0);
  TriangleMesh mesh = box;
  Append(Moved(T, box), {1, 2, 3}, mesh);
  EXPECT_EQ(mesh.size(), 24);
  EXPECT_EQ(mesh.colours.cols(), 24);
  EXPECT_EQ(mesh.triangles.rightCols(12).minCoeff(), 8);
  EXPECT_TRUE(mesh.vertices.rowwise().maxCoeff().isApprox(Vector3d(3, 2, 2)));
}

}  // namespace
}  // namespace armature
