// SPDX-License-Identifier: BSD-3-Clause
// The truth of edges in a picture.
#include <gtest/gtest.h>

#include "datasets/cad/solids.h"
#include "datasets/simulation/true_edges.h"

namespace armature {
namespace {

const Camera kEdgeCamera{640, 480, 500, 500, 319.5, 239.5};

// One edge from (-0.5, 0, 2) to (0.5, 0, 2), seen from the origin.
Wireframe OneEdge() {
  Wireframe wireframe{Eigen::Matrix3Xd(3, 1), Eigen::Matrix3Xd(3, 1)};
  wireframe.midpoints.col(0) = Eigen::Vector3d(0, 0, 2);
  wireframe.directions.col(0) = Eigen::Vector3d(1, 0, 0);
  return wireframe;
}

PlacedMesh Board(double left, double right, double near, int object) {
  PlacedMesh board;
  board.mesh.parts = {Block(Eigen::Vector3d(left, -0.3, near), Eigen::Vector3d(right, 0.3, near + 0.01), {})};
  board.object = object;
  return board;
}

std::vector<TrueEdge> Edges(std::vector<PlacedMesh> meshes, const Camera& camera = kEdgeCamera) {
  return FindTrueEdges(RayScene(std::move(meshes)), 1, OneEdge(), Eigen::Isometry3d::Identity(), camera,
                       Eigen::Isometry3d::Identity());
}

TEST(TrueEdges, AreWhereTheyProjectInTheirSense) {
  const auto edges = Edges({Board(3, 4, 1, 0)});
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_NEAR(edges[0].line.p1.x(), 319.5 - 125, 1e-9);
  EXPECT_NEAR(edges[0].line.p2.x(), 319.5 + 125, 1e-9);
  EXPECT_NEAR(edges[0].line.p1.y(), 239.5, 1e-9);
  EXPECT_EQ(edges[0].visible, 1);
}

TEST(TrueEdges, SomethingBeforeHidesAPart) {
  const auto edges = Edges({Board(-1, -0.125, 1, 0)});  // hides all that is left of x = -0.25 at 2 m
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_NEAR(edges[0].visible, 0.75, 0.03);
}

TEST(TrueEdges, LieWithinTheirObjectButNotBehindIt) {
  EXPECT_EQ(Edges({Board(-1, 1, 1.95, 1)})[0].visible, 1);  // 5 cm inside of its own post
  EXPECT_EQ(Edges({Board(-1, 1, 1.95, 0)})[0].visible, 0);  // 5 cm behind something else
  EXPECT_EQ(Edges({Board(-1, 1, 1.80, 1)})[0].visible, 0);  // behind its own back
}

TEST(TrueEdges, OnlyThePartInTheImageCounts) {
  Camera narrow = kEdgeCamera;
  narrow.cx = 0;
  const auto edges = Edges({Board(0.1, 1, 1.5, 0)}, narrow);
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_NEAR(edges[0].line.p1.x(), -0.5, 1e-9);
  EXPECT_NEAR(edges[0].visible, 0.1 / 1.5 * 2 / 0.5, 0.05);
  narrow.cx = -200;
  EXPECT_TRUE(Edges({Board(3, 4, 1, 0)}, narrow).empty());
}

}  // namespace
}  // namespace armature
