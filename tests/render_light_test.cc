// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "datasets/render/light.h"
#include "render_test_scenes.h"

namespace armature {
namespace {

using Eigen::Vector3d;
using testing::Placed;
using testing::Square;

const Lamp kLamp{{0, 0, 2}, {0.4, 0.4}, {1, 1, 1}, 1};

Light LightOf(const std::vector<PlacedMesh>& meshes, const std::vector<Lamp>& lamps = {kLamp}) {
  RenderOptions options;
  options.light_grid = 0.05;
  return ComputeLight(RayScene(meshes), ListSurfaces(meshes), lamps, options);
}

// Of the first mesh, a square of side 2 around the origin.
float At(const Light& light, double x, double y) {
  return light.grids[0].At(0.5 * (x + 1), 0.5 * (y + 1))[1];
}

TEST(Light, FallsOffWithDistanceAndBothCosines) {
  const Light light = LightOf({Placed(Square(), {0, 0, 0})});
  const double expected = std::pow(4 / (4 + 0.81), 2);  // (cosine / distance)^2 at x = 0.9 against the middle
  EXPECT_NEAR(At(light, 0.9, 0) / At(light, 0, 0), expected, 0.02);
}

TEST(Light, IsDarkerBelowABoardWithAPenumbraBetween) {
  Part board = Square();
  for (Vector3d& corner : board.quads[0].corners) corner *= 0.4;
  const Light light = LightOf({Placed(Square(), {0, 0, 0}), Placed(board, {0, 0, 0.5})});
  // Seen from the lamp's sides the board's edge at 0.4 is at (0.4 -+ 0.2) * 4 / 3 +- 0.2: 0.467 and 0.6.
  const float below = At(light, 0.2, 0), between = At(light, 0.533, 0), beside = At(light, 0.9, 0);
  EXPECT_LT(below, 0.15f * beside);
  EXPECT_GT(between, below + 0.25f * (beside - below));
  EXPECT_LT(between, below + 0.85f * (beside - below));
}

TEST(Light, FacesOfABlockDiffer) {
  const std::vector<PlacedMesh> meshes = {
      Placed(Square(), {0, 0, 0}),
      Placed(Block(Vector3d(0.3, 0.1, 0.2), Vector3d(0.6, 0.4, 0.5), {}), {0, 0, 0})};
  const Light light = LightOf(meshes);
  const Surfaces surfaces = ListSurfaces(meshes);
  float top = 0, side = 0, bottom = 0;
  for (size_t q = 1; q < surfaces.quads.size(); ++q) {
    const Vector3d& normal = surfaces.quads[q].normal;
    const float here = light.grids[q].At(0.5, 0.5)[1];
    if (normal.z() > 0.5) top = here;
    if (normal.z() < -0.5) bottom = here;
    if (normal.x() < -0.5) side = here;
  }
  EXPECT_GT(top, 1.3f * side);
  EXPECT_GT(side, bottom);
  EXPECT_GT(bottom, 0);  // by reflection only
}

TEST(Light, TakesOnTheColourOfWhatReflectsIt) {
  const Part red = Square({0.9, 0.1, 0.1}), grey = Square({0.5, 0.5, 0.5});
  PlacedMesh ceiling = Placed(grey, {0, 0, 1});
  ceiling.T_world_mesh.linear() = Vector3d(1, -1, -1).asDiagonal();
  Lamp low = kLamp;
  low.centre.z() = 0.9;
  const Light light = LightOf({Placed(red, {0, 0, 0}), ceiling}, {low});
  const Rgb above = light.grids[1].At(0.5, 0.5), below = light.grids[0].At(0.5, 0.5);
  EXPECT_GT(above[0] / above[1], 2 * below[0] / below[1]);
}

TEST(Light, DarknessDoesNotLeakOutOfSolids) {
  const Light light =
      LightOf({Placed(Square(), {0, 0, 0}),
               Placed(Block(Vector3d(0.0, -0.3, -0.1), Vector3d(0.6, 0.3, 0.02), {}), {0, 0, 0})});
  EXPECT_GT(At(light, -0.03, 0), 0.8f * At(light, -0.3, 0));
}

TEST(Light, IsTheSameForAnyNumberOfThreads) {
  const std::vector<PlacedMesh> meshes = {
      Placed(Square(), {0, 0, 0}), Placed(Block(Vector3d(0, 0, 0), Vector3d(0.3, 0.3, 0.3), {}), {0, 0, 0})};
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Light one = LightOf(meshes);
  omp_set_num_threads(2);
  const Light two = LightOf(meshes);
  omp_set_num_threads(threads);
  for (size_t q = 0; q < one.grids.size(); ++q) {
    for (size_t i = 0; i < one.grids[q].light.size(); ++i) {
      ASSERT_TRUE((one.grids[q].light[i] == two.grids[q].light[i]).all());
    }
  }
}

}  // namespace
}  // namespace armature
