// SPDX-License-Identifier: BSD-3-Clause
// Furniture that no category covers.
#include <gtest/gtest.h>

#include "datasets/scene/clutter.h"
#include "datasets/scene/distractors.h"
#include "datasets/scene/room_mesh.h"
#include "datasets/scene/scene_yaml.h"
#include "support/block_collection.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using Eigen::Vector3d;

class EachDistractor : public ::testing::TestWithParam<std::string> {};

TEST_P(EachDistractor, IsAsLargeAsItIsAskedFor) {
  for (int seed = 0; seed < 8; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Vector3d size = DrawDistractorSize(GetParam(), random);
    EXPECT_GT(size.minCoeff(), 0.25);
    EXPECT_LT(size.maxCoeff(), 2.3);
    const Colour colour = DrawDistractorColour(GetParam(), random);
    const Eigen::AlignedBox3d box = BoundingBox(ClutterMesh(GetParam(), size, colour, random));
    EXPECT_NEAR(box.min().z(), 0, 1e-9);
    EXPECT_LT((box.sizes() - size).maxCoeff(), 1e-9);
    EXPECT_GT((box.sizes().array() / size.array()).minCoeff(), 0.75) << box.sizes().transpose();
    EXPECT_LT(box.center().head<2>().norm(), 0.1);
  }
}

TEST_P(EachDistractor, HasPartsOfItsOwn) {
  Random random(1);
  const Vector3d size = DrawDistractorSize(GetParam(), random);
  const Mesh mesh = ClutterMesh(GetParam(), size, {0.5, 0.4, 0.3}, random);
  EXPECT_GE(mesh.parts.size(), 3U);
  for (const Part& part : mesh.parts) {
    EXPECT_GE(part.material.colour.minCoeff(), 0);
    EXPECT_LE(part.material.colour.maxCoeff(), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachDistractor, ::testing::ValuesIn(DistractorShapes()),
                         [](const auto& shape) { return shape.param; });

class DistractorScene : public ::testing::Test {
 protected:
  Scene Read(const std::string& clutter) const {
    return ReadScene(folder_.Write("scene.yaml",
                                   "name: test\nobjects:\n  - {id: desk, category: table, instance: "
                                   "table-0001, position: [1, 2]}\nclutter:\n" +
                                       clutter),
                     collection_);
  }

  testing::TempFolder folder_;
  std::vector<CadInstance> collection_ = testing::BlockCollection();
};

TEST_F(DistractorScene, NumbersThemAfterTheObjects) {
  const Scene scene = Read(
      "  - {shape: box, size: [0.3, 0.3, 0.3], position: [-3, -2]}\n"
      "  - {id: couch, shape: sofa, size: [1.8, 0.9, 0.8], position: [-2, 2.3]}\n"
      "  - {shape: stool, size: [0.35, 0.35, 0.45], position: [3, -2]}\n");
  ASSERT_EQ(Distractors(scene).size(), 2U);
  EXPECT_EQ(Distractors(scene)[0].id, "couch");
  EXPECT_EQ(Distractors(scene)[1].shape, "stool");
  std::vector<int> numbers;
  for (const PlacedMesh& mesh : SceneMeshes(scene)) {
    if (mesh.object != kRoom) numbers.push_back(mesh.object);
  }
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3}));
}

TEST_F(DistractorScene, ReportsIdsThatAreGivenTwice) {
  testing::ExpectInputError(
      [&] { Read("  - {id: desk, shape: stool, size: [0.4, 0.4, 0.5], position: [3, -2]}\n"); },
      {"scene.yaml:5:", "clutter[0].id", "given twice"});
}

}  // namespace
}  // namespace armature
