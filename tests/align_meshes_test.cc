// SPDX-License-Identifier: BSD-3-Clause
// Meshes turned to annotations that were made in another frame.
#include "cli/align_meshes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/mesh_shapes.h"

namespace armature {
namespace {

Eigen::Matrix3d HalfAxes(double x, double y, double z) { return Eigen::Vector3d(x, y, z).asDiagonal(); }

// A laptop in the axes of its annotations: a base, y up, and a screen at the end of -x.
TriangleMesh LaptopMesh() {
  TriangleMesh mesh = BoxMesh({0, 0, 0}, HalfAxes(0.3, 0.01, 0.2));
  Append(BoxMesh({-0.3, 0.2, 0}, HalfAxes(0.01, 0.2, 0.2)), ColourBytes(1, 2, 3), mesh);
  return mesh;
}

// Centred, of diagonal 1, as its annotations are.
Eigen::Affine3d ToAnnotations(const TriangleMesh& mesh) {
  const Eigen::Vector3d least = mesh.vertices.rowwise().minCoeff(), most = mesh.vertices.rowwise().maxCoeff();
  return Eigen::Scaling(1 / (most - least).norm()) * Eigen::Translation3d(-(least + most) / 2) *
         Eigen::Affine3d::Identity();
}

// The upper border of the screen, the hinge, and the front of the base.
Wireframe Annotations(const Eigen::Affine3d& T) {
  Wireframe wireframe;
  wireframe.midpoints.resize(3, 3);
  wireframe.midpoints << -0.3, -0.3, 0.3, 0.4, 0, 0, 0, 0, 0;
  wireframe.midpoints = T * wireframe.midpoints;
  wireframe.directions = Eigen::Vector3d(0, 0, 0.4 * T.linear()(2, 2)).replicate(1, 3);
  return wireframe;
}

TEST(AlignMeshes, EveryQuarterTurnIsFound) {
  const TriangleMesh upright = LaptopMesh();
  const Eigen::Affine3d T = ToAnnotations(upright);
  const TriangleMesh expected = Moved(T, upright);
  for (int quarter = 0; quarter < 4; ++quarter) {
    // As published: z up, of any unit and origin, turned.
    const Eigen::Affine3d published =
        Eigen::Translation3d(5, -3, 8) * Eigen::Scaling(40.0) *
        Eigen::AngleAxisd(quarter * std::numbers::pi / 2, Eigen::Vector3d::UnitZ()) *
        Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX());
    const TriangleMesh mesh = Moved(published, upright);
    const TriangleMesh aligned = Moved(AlignedToAnnotations(mesh, Annotations(T)), mesh);
    EXPECT_LT((aligned.vertices - expected.vertices).cwiseAbs().maxCoeff(), 1e-9) << quarter << " quarters";
  }
}

TEST(AlignMeshes, KnownFramesAndModelsWithoutSurfaceAreLeftAlone) {
  std::vector<CadModel> models(2);
  models[0].geometry = "is not read.off";
  models[0].T_annotation_geometry = Eigen::Affine3d(Eigen::Scaling(3.0));
  AlignMeshes("nowhere", models);
  EXPECT_EQ(models[0].T_annotation_geometry->linear()(0, 0), 3);
  EXPECT_FALSE(models[1].T_annotation_geometry);
}

}  // namespace
}  // namespace armature
