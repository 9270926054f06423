// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "io/annotations.h"
#include "io/category_yaml.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::CategoryFolder;
using testing::ExpectInputError;
using testing::FrameSpec;
using testing::FrameWireframe;
using testing::TempFolder;

const char* const kHeader = "model,edge,x1,y1,z1,x2,y2,z2\n";
const char* const kLeft = "a,left,-0.5,0,-0.5,-0.5,0,0.5\n";
const char* const kRight = "a,right,0.5,0,-0.5,0.5,0,0.5\n";
const char* const kBar = "a,bar,-0.5,0,-0.5,0.5,0,-0.5\n";

std::vector<AnnotatedModel> ReadEdges(const std::string& rows) {
  const TempFolder folder;
  return ReadAnnotations(folder.Write("models.csv", kHeader + rows), "edges", FrameSpec().category);
}

TEST(Annotations, EdgesMayComeInAnyOrder) {
  const auto models = ReadEdges(std::string(kBar) + kRight + "\n# a comment\n" + kLeft);
  ASSERT_EQ(models.size(), 1u);
  EXPECT_EQ(models[0].id, "a");
  EXPECT_EQ(ShapeVector(models[0].wireframe), ShapeVector(FrameWireframe()));
}

TEST(Annotations, BadEdgesAreNamedWithFileAndLine) {
  const std::string all = std::string(kLeft) + kRight + kBar;
  ExpectInputError([&] { ReadEdges(std::string(kLeft) + kRight); }, {"models.csv:3", "'a'", "'bar'"});
  ExpectInputError([&] { ReadEdges(all + kBar); }, {"models.csv:5", "'bar'", "line 4"});
  ExpectInputError([&] { ReadEdges(all + "a,bra,0,0,0,1,1,1\n"); }, {"models.csv:5", "'bra'", "'bar'"});
  ExpectInputError([&] { ReadEdges("a,left,1,1,1,1,1,1\n"); }, {"models.csv:2", "no length"});
  ExpectInputError([&] { ReadEdges("a,left,nan,1,1,1,1,1\n"); }, {"models.csv:2", "x1"});
  ExpectInputError([&] { ReadEdges(""); }, {"models.csv", "no usable model"});
}

TEST(Annotations, UnknownFormatNamesTheNearest) {
  ExpectInputError([] { ReadAnnotations("models.csv", "keypointnet_chairs", FrameSpec().category); },
                   {"'keypointnet_chairs'", "keypointnet_chair"});
}

TEST(Annotations, ATableOfAnotherCategoryIsRefused) {
  ExpectInputError([] { ReadAnnotations("models.csv", "modelnet_laptop", FrameSpec().category); },
                   {"modelnet_laptop", "'left'", "format edges"});
}

// A chair of KeypointNet's orientation: back at +z, s0 at +x; a second one that is not sane.
std::string KeypointNetRows() {
  std::string header = "model_id,sane";
  std::string row;
  const std::vector<std::pair<const char*, const char*>> points = {
      {"s0", "0.2,0.5,0.2"},    {"s1", "-0.2,0.5,0.2"},   {"s2", "0.2,0,0.2"},      {"s3", "-0.2,0,0.2"},
      {"s4", "0.2,0,-0.2"},     {"s5", "-0.2,0,-0.2"},    {"s17", "0.2,-0.4,-0.2"}, {"s18", "0.2,-0.4,0.2"},
      {"s19", "-0.2,-0.4,0.2"}, {"s20", "-0.2,-0.4,-0.2"}};
  for (const auto& [name, position] : points) {
    for (const char* axis : {"_x", "_y", "_z"}) header += std::string(",") + name + axis;
    row += std::string(",") + position;
  }
  return header + "\ngood,1" + row + "\nbad,0" + row + "\n";
}

TEST(Annotations, KeypointNetChairsAreTurnedToFaceForward) {
  const TempFolder folder;
  const CategorySpec spec = LoadCategorySpec(CategoryFolder() / "specs" / "chair.yaml");
  const auto models =
      ReadAnnotations(folder.Write("chairs.csv", KeypointNetRows()), "keypointnet_chair", spec);
  ASSERT_EQ(models.size(), 1u);
  const Wireframe& chair = models[0].wireframe;
  EXPECT_EQ(chair.End(0, 0), Eigen::Vector3d(-0.2, 0.5, -0.2));    // back_top starts left, at the rear
  EXPECT_EQ(chair.End(7, 1), Eigen::Vector3d(-0.2, -0.4, 0.2));    // leg_front_left ends on the floor
  EXPECT_EQ(chair.End(10, 1), Eigen::Vector3d(0.2, -0.4, 0.2));    // leg_front_right
  EXPECT_EQ(chair.directions.col(5), Eigen::Vector3d(0, 0, 0.4));  // seat_left, rear to front
}

}  // namespace
}  // namespace armature
