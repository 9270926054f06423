// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "category/learn.h"
#include "datasets/cad/collection_files.h"
#include "datasets/cad/solids.h"
#include "io/category_yaml.h"
#include "io/csv.h"
#include "io/training_models.h"
#include "support/category_examples.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ReadFile;
using testing::TempFolder;

int CountFrames(const std::string& ply, const std::string& element) {
  const size_t start = ply.find("element " + element + " ");
  return start == std::string::npos ? -1 : std::stoi(ply.substr(start + element.size() + 9));
}

TEST(Ply, HoldsABoxAsEightVerticesAndTwelveColouredTriangles) {
  Material red;
  red.colour = {1, 0.2, 0};
  const std::string ply =
      CadPlyText(Mesh{{Block(Eigen::Vector3d(-1, -2, -3), Eigen::Vector3d(1, 2, 3), red)}});
  EXPECT_EQ(CountFrames(ply, "vertex"), 8);
  EXPECT_EQ(CountFrames(ply, "face"), 12);
  const size_t body = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size() - body, 8u * 12 + 12u * 16);
  float first[3];
  std::memcpy(first, ply.data() + body, sizeof(first));
  EXPECT_EQ(Eigen::Vector3f(first).cwiseAbs(), Eigen::Vector3f(1, 2, 3));
  const std::string face = ply.substr(body + 8 * 12, 16);
  EXPECT_EQ(face[0], 3);
  EXPECT_EQ(face.substr(13), std::string("\xFF\x33\0", 3));
}

TEST(Ply, ATriangleIsOneFace) {
  Part part;
  part.quads.push_back({{Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}});
  EXPECT_EQ(CountFrames(CadPlyText(Mesh{{part}}), "face"), 1);
}

TEST(CollectionFiles, TheWholeCollectionIsSmall) {
  size_t bytes = 0;
  for (const CadInstance& instance : DrawCollection({})) bytes += CadPlyText(instance.mesh).size();
  EXPECT_LT(bytes, 5'000'000u);
}

TEST(CollectionFiles, EveryInstanceHasItsRowAndItsMesh) {
  const TempFolder folder;
  const std::vector<CadInstance> collection = DrawCollection({12, 3, 3, 2});
  WriteCollection(collection, folder.path());
  const CsvTable table(folder / "instances.csv", {"id", "category", "held_out", "size_x", "mesh"});
  ASSERT_EQ(table.rows().size(), collection.size());
  for (size_t i = 0; i < collection.size(); ++i) {
    const CsvRow& row = table.rows()[i];
    EXPECT_EQ(row.Text("id"), collection[i].id);
    EXPECT_EQ(row.Integer("held_out"), collection[i].held_out ? 1 : 0);
    EXPECT_NEAR(row.Number("size_z"), collection[i].size.z(), 1e-6);
    EXPECT_EQ(ReadFile(folder / row.Text("mesh")), CadPlyText(collection[i].mesh));
  }
}

TEST(CollectionFiles, HeldOutModelsAreOnlyInTheirOwnFile) {
  const TempFolder folder;
  WriteCollection(DrawCollection({12, 3, 3, 2}), folder.path());
  EXPECT_EQ(CsvTable(folder / "chair_edges.csv", {"model"}).rows().size(), 11u * 11);
  const CsvTable held_out(folder / "chair_edges_held_out.csv", {"model"});
  ASSERT_EQ(held_out.rows().size(), 11u);
  EXPECT_EQ(held_out.rows()[0].Text("model"), "chair-0010");
  EXPECT_EQ(ReadFile(folder / "chair_edges.csv").find("chair-0010"), std::string::npos);
}

TEST(CollectionFiles, SameSeedSameBytes) {
  const TempFolder a, b;
  WriteCollection(DrawCollection({3, 3, 3, 2}), a.path());
  WriteCollection(DrawCollection({3, 3, 3, 2}), b.path());
  for (const char* name : {"instances.csv", "laptop_edges.csv", "chair/chair-0002.ply"}) {
    EXPECT_EQ(ReadFile(a / name), ReadFile(b / name));
  }
}

TEST(CollectionFiles, AFolderThatCannotBeIsAnError) {
  const TempFolder folder;
  folder.Write("file", "");
  EXPECT_THROW(WriteCollection(DrawCollection({1, 0, 0, 1}), folder / "file/folder"), std::runtime_error);
}

TEST(CollectionFiles, CategoriesAreLearntFromThemWithTheSpreadOfTheirSizes) {
  const TempFolder folder;
  WriteCollection(DrawCollection({40, 40, 40, 2}), folder.path());
  for (const std::string name : {"chair", "table", "laptop"}) {
    const TrainingSpec spec = LoadTrainingSpec(testing::CategoryFolder() / "specs" / (name + ".yaml"));
    const std::filesystem::path file = folder / (name + "_edges.csv");
    const TrainingModels scaled = AnnotatedTrainingModels(spec, {file, "edges"});
    const TrainingModels metric = AnnotatedTrainingModels(spec, {file, "edges", true});
    EXPECT_EQ(scaled.read, 36);
    EXPECT_GE(metric.wireframes.size(), 34u) << name;
    const int scaled_modes = LearnCategory(spec, scaled.wireframes, "").modes();
    const int metric_modes = LearnCategory(spec, metric.wireframes, "").modes();
    // Four measures make a laptop's shape; scaling takes one away. The others have more measures than modes.
    EXPECT_EQ(metric_modes, name == "laptop" ? 4 : 7);
    EXPECT_EQ(scaled_modes, name == "laptop" ? 3 : name == "table" ? 6 : 7);
  }
}

}  // namespace
}  // namespace armature
