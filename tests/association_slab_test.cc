// SPDX-License-Identifier: BSD-3-Clause
// Boards are seen by the lower outline of the sides that face the camera.
#include <gtest/gtest.h>

#include "association/matching.h"
#include "association/projection.h"

namespace armature {
namespace {

constexpr double kDrop = 0.02;
const Camera kSlabCamera{640, 480, 500, 500, 319.5, 239.5, {}};
const Box kEverywhere{-1e4, -1e4, 2e4, 2e4};

// A square board of 1 m: edges rear, right, front, left.
struct SlabView {
  CategorySpec spec;
  Wireframe board{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xd(3, 4)};
  ProjectedWireframe projected;

  // Its centre 3 m ahead of a level camera and `below` metres lower, its front towards the camera.
  explicit SlabView(double below) {
    spec.edge_names = {"rear", "right", "front", "left"};
    spec.slab = SlabOutline{{0, 1, 2, 3}, kDrop};
    board.midpoints << 0, 0.5, 0, -0.5, 0, 0, 0, 0, -0.5, 0, 0.5, 0;
    board.directions << 1, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1;
    Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();
    T_camera_object.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // y up, front to the camera
    T_camera_object.translation() = Eigen::Vector3d(0, below, 3);
    ProjectSeenEdges(kSlabCamera, spec, board, T_camera_object, kEverywhere, projected);
  }
};

TEST(SlabOutline, OnlyTheNearSideIsSeenLower) {
  const SlabView view(0.5);
  EXPECT_EQ(view.projected.edges[2].drop, kDrop);
  EXPECT_NEAR(view.projected.edges[2].line.p1.y(), 239.5 + 500 * (0.5 + kDrop) / 2.5, 1e-9);
  EXPECT_NEAR(view.projected.edges[2].slack, 500 * kDrop / 2.5, 1e-9);
  for (const size_t hidden : {0, 1, 3}) EXPECT_EQ(view.projected.edges[hidden].drop, 0) << hidden;
  EXPECT_NEAR(view.projected.edges[0].line.p1.y(), 239.5 + 500 * 0.5 / 3.5, 1e-9);
}

TEST(SlabOutline, FromBelowTheEdgeItselfIsSeen) {
  const SlabView view(-0.5);
  for (const ProjectedEdge& edge : view.projected.edges) EXPECT_EQ(edge.drop, 0);
}

TEST(SlabOutline, BothOutlinesMatchTheNearSide) {
  const SlabView view(0.5);
  const auto quality = [&](double drop) {
    const double y = 239.5 + 500 * (0.5 + drop) / 2.5;
    return ComparePair(view.projected.edges[2], {{260, y}, {380, y}}, {1.0, 0.1}).quality;
  };
  EXPECT_NEAR(quality(kDrop), 1, 1e-9);
  EXPECT_GT(quality(0), 0);
  EXPECT_GT(quality(2 * kDrop), 0);
  EXPECT_EQ(quality(3 * kDrop), 0);
}

}  // namespace
}  // namespace armature
