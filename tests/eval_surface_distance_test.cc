// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/mesh_shapes.h"
#include "geometry/surface_distance.h"

namespace armature {
namespace {

// A unit square at height z, corner at the origin.
TriangleMesh UnitSquareAt(double z) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2), {}};
  mesh.vertices << 0, 1, 1, 0, 0, 0, 1, 1, z, z, z, z;
  mesh.triangles << 0, 0, 1, 2, 2, 3;
  return mesh;
}

SurfacePoints MakePoints(const TriangleMesh& mesh, int count = 4000, std::uint64_t seed = 1) {
  return SurfacePoints(SampleSurface(mesh, count, seed));
}

TEST(SampledSurface, PointsOfASquareHaveItsMeanAndCovariance) {
  const Eigen::Matrix3Xd points = SampleSurface(UnitSquareAt(2), 20000, 3).cast<double>();
  const Eigen::Vector3d mean = points.rowwise().mean();
  EXPECT_NEAR((mean - Eigen::Vector3d(0.5, 0.5, 2)).norm(), 0, 0.005);
  const Eigen::Matrix3Xd centred = points.colwise() - mean;
  const Eigen::Matrix3d covariance = centred * centred.transpose() / static_cast<double>(points.cols());
  const Eigen::Matrix3d expected = Eigen::Vector3d(1. / 12, 1. / 12, 0).asDiagonal();
  EXPECT_NEAR((covariance - expected).norm(), 0, 0.002);
  EXPECT_GE(points.minCoeff(), 0);
  EXPECT_LE(points.topRows<2>().maxCoeff(), 1);
}

TEST(SampledSurface, EveryTriangleGetsItsShareOfTheArea) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 6), Eigen::Matrix3Xi(3, 3), {}};
  mesh.vertices << 0, 1, 0, 5, 8, 5,  // areas 1/2 and 3/2
      0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0;
  mesh.triangles << 0, 1, 3, 1, 1, 4, 2, 1, 5;  // the middle one has none
  const Eigen::Matrix3Xf points = SampleSurface(mesh, 1000, 1);
  EXPECT_EQ((points.row(0).array() < 2).count(), 250);
  EXPECT_EQ((points.row(0).array() >= 5).count(), 750);
}

TEST(SampledSurface, IsTheSameForTheSameSeedOnly) {
  const TriangleMesh ball = BallMesh({0, 0, 0}, 1);
  EXPECT_EQ(SampleSurface(ball, 50, 7), SampleSurface(ball, 50, 7));
  EXPECT_NE(SampleSurface(ball, 50, 7), SampleSurface(ball, 50, 8));
  // Stays the same on every platform.
  const Eigen::Vector3f first = SampleSurface(UnitSquareAt(0), 1, 1).col(0);
  EXPECT_NEAR((first - Eigen::Vector3f(0.369333f, 0.166649f, 0)).norm(), 0, 1e-5);
}

TEST(SurfaceDistances, OfParallelSquaresIsTheirDistance) {
  const SurfaceDistance distance =
      CompareSurfaces(MakePoints(UnitSquareAt(0)), MakePoints(UnitSquareAt(0.3)), 0.02);
  EXPECT_NEAR(distance.chamfer, 0.3, 1e-3);
  EXPECT_EQ(distance.precision, 0);
  EXPECT_EQ(distance.recall, 0);
  EXPECT_EQ(distance.f_score, 0);
}

TEST(SurfaceDistances, OfIdenticalSurfacesIsZero) {
  const TriangleMesh ball = BallMesh({1, 2, 3}, 0.5);
  const SurfaceDistance distance = CompareSurfaces(MakePoints(ball), MakePoints(ball), 0.02);
  EXPECT_EQ(distance.chamfer, 0);
  EXPECT_EQ(distance.f_score, 1);
  // Other points of the same surface are about half their spacing apart.
  const SurfaceDistance sampled = CompareSurfaces(MakePoints(ball, 4000, 1), MakePoints(ball, 4000, 2), 0.05);
  EXPECT_LT(sampled.chamfer, 0.5 * std::sqrt(3.14 / 4000) * 1.2);
  EXPECT_EQ(sampled.f_score, 1);
}

TEST(SurfaceDistances, OfBallsIsTheDifferenceOfTheirRadii) {
  const SurfaceDistance distance = CompareSurfaces(MakePoints(BallMesh({0, 0, 0}, 1), 20000),
                                                   MakePoints(BallMesh({0, 0, 0}, 1.2), 20000), 0.3);
  EXPECT_NEAR(distance.chamfer, 0.2, 0.01);
  EXPECT_EQ(distance.f_score, 1);
}

TEST(SurfaceDistances, PrecisionIsOfTheRetrievedAndRecallOfTheTrueSurface) {
  TriangleMesh both = UnitSquareAt(0);
  Append(UnitSquareAt(1), ColourBytes::Zero(), both);
  const SurfaceDistance missing = CompareSurfaces(MakePoints(UnitSquareAt(0)), MakePoints(both), 0.1);
  EXPECT_EQ(missing.precision, 1);
  EXPECT_EQ(missing.recall, 0.5);
  EXPECT_NEAR(missing.f_score, 2. / 3, 1e-12);
  EXPECT_NEAR(missing.chamfer, 0.25, 0.01);
  const SurfaceDistance too_much = CompareSurfaces(MakePoints(both), MakePoints(UnitSquareAt(0)), 0.1);
  EXPECT_EQ(too_much.precision, 0.5);
  EXPECT_EQ(too_much.recall, 1);
}

TEST(SurfaceDistances, AreThoseOfTheNearestPoint) {
  Eigen::Matrix3Xf points(3, 3), queries(3, 2);
  points << 0, 1, 5, 0, 0, 0, 0, 0, 0;
  queries << 0.9f, 5, 0, 3, 0, 4;
  const Eigen::VectorXf distances = SurfacePoints(points).MeasureDistances(queries);
  EXPECT_NEAR(distances[0], 0.1, 1e-6);
  EXPECT_NEAR(distances[1], 5, 1e-6);
}

}  // namespace
}  // namespace armature
