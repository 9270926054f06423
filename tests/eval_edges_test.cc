// SPDX-License-Identifier: BSD-3-Clause
// True edges: where CAD annotations come to lie, what of them is seen, which segments are on them.
#include <gtest/gtest.h>

#include "io/sequence.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"
#include "support/true_world.h"
#include "truth/true_scene.h"

namespace armature {
namespace {

VisibleEdge HorizontalEdge() {
  VisibleEdge edge;
  edge.line = {{100, 50}, {200, 50}};
  edge.in_image = true;
  edge.pixels_per_metre = 200;
  for (int x = 100; x < 200; ++x) edge.samples.push_back({x + 0.5, 50});
  return edge;
}

TEST(EvalEdges, LiesOnEdge) {
  const VisibleEdge edge = HorizontalEdge();
  const EdgeTolerance tolerance;
  EXPECT_TRUE(LiesOnEdge({{110, 53}, {190, 47}}, edge, tolerance));
  EXPECT_TRUE(LiesOnEdge({{190, 50}, {250, 50}}, edge, tolerance)) << "sticks out";
  EXPECT_FALSE(LiesOnEdge({{110, 55}, {190, 55}}, edge, tolerance)) << "too far";
  EXPECT_FALSE(LiesOnEdge({{140, 48}, {155, 51}}, edge, tolerance)) << "turned by 11 degrees";
  EXPECT_FALSE(LiesOnEdge({{201, 50}, {250, 50}}, edge, tolerance)) << "beyond the end";
  EXPECT_TRUE(LiesOnEdge({{110, 62}, {190, 62}}, edge, {.distance = 4, .metres = 0.05, .angle_deg = 6}));
  EXPECT_FALSE(LiesOnEdge({{110, 50}, {190, 50}}, VisibleEdge(), tolerance)) << "edge outside the image";
}

TEST(EvalEdges, CoveredLengthCountsOverlapsOnce) {
  const VisibleEdge edge = HorizontalEdge();
  EXPECT_EQ(CoveredLength(edge, {}, {}), 0);
  EXPECT_NEAR(CoveredLength(edge, {{{120, 51}, {150, 51}}, {{140, 49}, {160, 49}}}, {}), 40, 1);
  EXPECT_EQ(CoveredLength(edge, {{{150, 0}, {150, 100}}, {{100, 60}, {200, 60}}}, {}), 0);
}

TEST(EvalEdges, FittedToSizeMovesAndScales) {
  CadModel model;
  model.wireframe = {Eigen::Vector3d(3, 1, 1), Eigen::Vector3d(2, 0, 0)};
  model.box_min = {0, 0, 0};
  model.box_max = {4, 2, 2};
  const Wireframe fitted = FittedToSize(model, {8, 1, 2});
  EXPECT_TRUE(fitted.midpoints.col(0).isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_TRUE(fitted.directions.col(0).isApprox(Eigen::Vector3d(4, 0, 0)));
}

TEST(EvalEdges, ObjectsHideOneAnother) {
  testing::TrueWorld world;
  const auto visible = [&] {
    const TrueScene scene(world.sequence, world.models, world.cad);
    const auto edges = scene.EdgesSeen(0, TimedPose());
    double length = 0;
    if (!edges) return length;
    for (const VisibleEdge& edge : *edges) length += edge.visible_length();
    return length;
  };
  const double alone = visible();
  world.sequence.truth.objects[1].T_world_object = testing::SeenFrom(0, 40, {-0.7, -0.1, 1.8});
  EXPECT_LT(visible(), 0.9 * alone);
}

TEST(EvalEdges, NearestSymmetryStep) {
  const Eigen::Matrix3d R = testing::SeenFrom(10, 20, {0, 0, 3}).linear();
  const Eigen::Matrix3d turned = R * Eigen::AngleAxisd(170 * kDegree, Eigen::Vector3d::UnitY());
  EXPECT_EQ(NearestSymmetryStep(R, R, 2), 0);
  EXPECT_EQ(NearestSymmetryStep(turned, R, 2), 1);
  EXPECT_EQ(NearestSymmetryStep(turned, R, 1), 0);
}

TEST(EvalEdges, FolderWithoutCad) {
  const testing::TempFolder folder;
  testing::ExpectInputError([&] { CadLibrary(folder.path(), testing::ShippedSpecs()); },
                            {folder.path().string()});
}

// What is seen of the objects' own edges lies inside the detections' boxes and nearly fills them: boxes have
// 2 % noise, and things without CAD model hide some edges.
TEST(EvalEdges, SharedModelsFillTheirBoxes) {
  ARMATURE_SHARED_DATA_OR_SKIP(folder, "sequences/office_dev");
  ARMATURE_SHARED_DATA_OR_SKIP(cad_folder, "cad");
  const std::vector<CategoryModel> models = LoadCategories(testing::CategoryFolder());
  const CadLibrary cad(cad_folder, CollectSpecs(models));
  const SequenceTruth world = LoadSequenceTruth(folder, CollectSpecs(models));
  const TrueScene scene(world, models, cad);
  const Sequence sequence = LoadSequence(folder, {"chair", "laptop", "table"});
  double samples = 0, inside = 0;
  int boxes = 0, filled = 0;
  for (size_t i = 0; i < sequence.images.size(); ++i) {
    for (size_t k = 0; k < sequence.detections[i].size(); ++k) {
      const double timestamp = sequence.images[i].timestamp;
      const TrueObject* object = world.truth.FindObject(timestamp, static_cast<int>(k));
      const auto camera = FindStamp(world.truth.T_world_camera, timestamp);
      if (!object || !camera) continue;
      const auto index = static_cast<size_t>(object - world.truth.objects.data());
      const auto edges = scene.EdgesSeen(index, world.truth.T_world_camera[*camera]);
      ASSERT_TRUE(edges) << object->instance;
      const Box& box = sequence.detections[i][k].box;
      const Box grown = box.Grown(0.05 * std::max(box.width, box.height));
      Eigen::AlignedBox2d extent;
      for (const VisibleEdge& edge : *edges) {
        for (const Eigen::Vector2d& sample : edge.samples) {
          extent.extend(sample);
          ++samples;
          inside += grown.Contains(sample) ? 1 : 0;
        }
      }
      ++boxes;
      filled += extent.sizes().x() > 0.7 * box.width && extent.sizes().y() > 0.7 * box.height ? 1 : 0;
    }
  }
  ASSERT_GT(boxes, 100);
  EXPECT_GT(inside / samples, 0.97);
  EXPECT_GT(filled, 0.9 * boxes) << boxes;
}

}  // namespace
}  // namespace armature
