// SPDX-License-Identifier: BSD-3-Clause
// `armature learn`, through its command line.
#include "app/learn/learn_command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "category/kept_apart.h"
#include "datasets/cad/collection_files.h"
#include "datasets/cad/families.h"
#include "io/category_yaml.h"
#include "io/library_file.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::CategoryFolder;
using testing::ExpectInputError;
using testing::ReadFile;
using testing::TempFolder;

// What the command prints; fails the test when its exit status is not 0.
std::string Learn(const std::string& arguments) {
  CLI::App app;
  int exit_status = -1;
  AddLearnCommand(app, SampleFamily, exit_status);
  ::testing::internal::CaptureStdout();
  try {
    app.parse("learn " + arguments);
  } catch (...) {
    ::testing::internal::GetCapturedStdout();
    throw;
  }
  std::fflush(stdout);
  EXPECT_EQ(exit_status, 0);
  return ::testing::internal::GetCapturedStdout();
}

std::string Spec(const std::string& category) {
  return "--spec " + (CategoryFolder() / "specs" / (category + ".yaml")).string();
}

TEST(LearnCommand, LearnsTheShippedTableAgain) {
  const TempFolder folder;
  const auto file = folder / "table.yaml";
  const std::string text = Learn(Spec("table") + " --family table --out " + file.string());
  EXPECT_NE(text.find("2000 plausible of 2000"), std::string::npos) << text;
  EXPECT_NE(text.find(file.string()), std::string::npos) << text;
  const CategoryModel learnt = LoadCategory(file), shipped = LoadCategory(CategoryFolder() / "table.yaml");
  EXPECT_LT((learnt.mean - shipped.mean).norm(), 1e-7);
  EXPECT_EQ(learnt.source, shipped.source);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".partial"));
}

// One of six models by this rule; the others are what is learnt from.
TEST(LearnCommand, LeavesOutTheModelsThatRoomsAreDrawnFrom) {
  const TempFolder folder;
  const std::vector<CadInstance> chairs = DrawCollection({.chairs = 60, .tables = 0, .laptops = 0});
  WriteCollection(chairs, folder.path());
  int kept_apart = 0, all = 0;
  for (const CadInstance& chair : chairs) {
    if (chair.held_out) continue;
    ++all;
    kept_apart += IsKeptApart(chair.id) ? 1 : 0;
  }
  ASSERT_GT(kept_apart, 0);
  const std::string arguments = Spec("chair") + " --metric --annotations " +
                                (folder / "chair_edges.csv").string() + " --out " +
                                (folder / "chair.yaml").string();
  EXPECT_NE(Learn(arguments).find(fmt::format(" of {}", all)), std::string::npos);
  EXPECT_NE(Learn(arguments + " --without-held-out").find(fmt::format(" of {}", all - kept_apart)),
            std::string::npos);
  ExpectInputError(
      [&] {
        Learn(Spec("table") + " --family table --without-held-out --out " + (folder / "t.yaml").string());
      },
      {"--without-held-out", "--annotations"});
}

TEST(LearnCommand, WritesIntoAFolderThatDoesNotExistYet) {
  const TempFolder folder;
  const auto file = folder / "my/categories/laptop.yaml";
  Learn(Spec("laptop") + " --family laptop --count 20 --out " + file.string());
  EXPECT_EQ(LoadCategory(file).training_models, 20);
}

TEST(LearnCommand, SameSeedSameBytesOtherSeedOthers) {
  const TempFolder folder;
  const std::string start = Spec("laptop") + " --family laptop --count 50 --out " + folder.path().string();
  Learn(start + "/a.yaml --seed 3");
  Learn(start + "/b.yaml --seed 3");
  Learn(start + "/c.yaml --seed 4");
  EXPECT_EQ(ReadFile(folder / "a.yaml"), ReadFile(folder / "b.yaml"));
  EXPECT_NE(ReadFile(folder / "a.yaml"), ReadFile(folder / "c.yaml"));
}

TEST(LearnCommand, JsonHoldsVarianceAndHeldOutErrors) {
  const auto json = nlohmann::json::parse(
      Learn(Spec("table") + " --family table --count 200 --modes 5 --held-out 4 --json"));
  EXPECT_EQ(json["category"], "table");
  EXPECT_EQ(json["explained_variance"].size(), 5u);
  EXPECT_EQ(json["held_out_every"], 4);
  EXPECT_EQ(json["held_out"][0]["modes"], 3);
  EXPECT_EQ(json["held_out"][0]["models"], 50);
  EXPECT_GT(json["held_out"][0]["midpoint_m"], json["held_out"][1]["midpoint_m"]);
}

TEST(LearnCommand, LearnsFromAnnotatedEdges) {
  const TempFolder folder;
  folder.Write("spec.yaml",
               "category: rod\nedges: [across, along]\nbase_edges: [along, across]\n"
               "reference: {measure: length, edges: [across], metres: 1}\ntraining: {mirrored: false}\n");
  std::string rows = "model,edge,x1,y1,z1,x2,y2,z2\n";
  for (int i = 1; i <= 4; ++i) {
    rows += fmt::format("m{0},across,0,0,0,{0},0,0\nm{0},along,0,0,0,0,0,5\n", i);
  }
  folder.Write("models.csv", rows);
  const std::string root = folder.path().string();
  Learn("--spec " + root + "/spec.yaml --annotations " + root + "/models.csv --out " + root + "/rod.yaml");
  const CategoryModel model = LoadCategory(folder / "rod.yaml");
  EXPECT_EQ(model.training_models, 4);
  const Wireframe mean = WireframeFromVector(model.mean);
  EXPECT_NEAR(mean.directions(0, 0), 1, 1e-9);  // scaled to one metre
  EXPECT_NEAR(mean.directions(2, 1), 5 * (1 + 1 / 2.0 + 1 / 3.0 + 1 / 4.0) / 4, 1e-7);
}

TEST(LearnCommand, ComparesAFamilyWithItself) {
  const std::string arguments = Spec("chair") + " --family chair --count 200 --compare-family chair";
  const auto json = nlohmann::json::parse(Learn(arguments + " --json"))["comparison"];
  EXPECT_EQ(json["models_read"], 200);
  for (const double mean : json["others"]["mean"]) EXPECT_NEAR(mean, 0, 1e-6);
  for (const double deviation : json["others"]["deviation"]) EXPECT_NEAR(deviation, 1, 1e-6);
  EXPECT_EQ(json["own"]["midpoint_m"], json["others"]["midpoint_m"]);
  EXPECT_NE(Learn(arguments).find("others std"), std::string::npos);
}

TEST(LearnCommand, MetricAnnotationsKeepTheirSizes) {
  const TempFolder folder;
  folder.Write("spec.yaml",
               "category: rod\nedges: [across, along]\nbase_edges: [along, across]\n"
               "reference: {measure: length, edges: [across], metres: 1}\ntraining: {mirrored: false}\n");
  std::string rows = "model,edge,x1,y1,z1,x2,y2,z2\n";
  for (const int i : {1, 3}) rows += fmt::format("m{0},across,0,0,0,{0},0,0\nm{0},along,0,0,0,0,0,5\n", i);
  folder.Write("models.csv", rows);
  const std::string root = folder.path().string(), models = root + "/models.csv";
  Learn("--spec " + root + "/spec.yaml --annotations " + models + " --metric --out " + root + "/rod.yaml");
  const Wireframe mean = WireframeFromVector(LoadCategory(folder / "rod.yaml").mean);
  EXPECT_NEAR(mean.directions(0, 0), 2, 1e-9);
  EXPECT_NEAR(mean.directions(2, 1), 5, 1e-9);
}

TEST(LearnCommand, WritesALibraryOfTheModelAsItCanBeReadAgain) {
  const TempFolder folder;
  WriteCollection(DrawCollection({.chairs = 0, .tables = 20, .laptops = 0}), folder.path());
  const std::string root = folder.path().string();
  const std::string out =
      Learn(Spec("table") + " --annotations " + root + "/table_edges.csv --metric --out " + root +
            "/table.yaml --library " + root + "/tables.armlib");
  EXPECT_NE(out.find("tables.armlib"), std::string::npos) << out;
  const InstanceLibrary library =
      ReadLibrary(folder / "tables.armlib", {LoadCategory(folder / "table.yaml")});
  EXPECT_EQ(library.Of("table")->size(), 20) << "those that it did not learn from, too";
  EXPECT_TRUE(std::filesystem::equivalent(library.root, folder.path())) << library.root;
}

TEST(LearnCommand, BadUsageIsOneLine) {
  for (const std::string also : {" --out a.yaml", " --held-out 4"}) {
    ExpectInputError([&] { Learn(Spec("table") + " --family table --library a.armlib" + also); },
                     {"--library", "--annotations", "--out"});
  }
  ExpectInputError([] { Learn(Spec("table") + " --family table --metric --held-out 4"); }, {"--metric"});
  ExpectInputError([] { Learn(Spec("table") + " --family table --compare a.csv --compare-family table"); },
                   {"--compare FILE", "--compare-family"});
  ExpectInputError([] { Learn(Spec("table") + " --family table --compare absent.csv"); }, {"absent.csv"});
  ExpectInputError([] { Learn(Spec("table") + " --family table --compare-family sofa"); }, {"'sofa'"});
  ExpectInputError([] { Learn(Spec("table") + " --family table"); }, {"--out", "--held-out"});
  ExpectInputError([] { Learn(Spec("table") + " --held-out 4"); }, {"--annotations", "--family"});
  ExpectInputError([] { Learn(Spec("table") + " --family sofa --held-out 4"); },
                   {"'sofa'", "chair, table, laptop"});
  ExpectInputError([] { Learn(Spec("chair") + " --family table --held-out 4"); }, {"edges", "specification"});
  ExpectInputError([] { Learn(Spec("table") + " --family table --held-out 1"); }, {"--held-out 1"});
  ExpectInputError([] { Learn(Spec("table") + " --family table --held-out 4 --modes 99"); }, {"--modes 99"});
  ExpectInputError([] { Learn("--spec absent.yaml --family table --held-out 4"); }, {"absent.yaml"});
  ExpectInputError([] { Learn(Spec("table") + " --annotations absent.csv --held-out 4"); }, {"absent.csv"});
}

TEST(LearnCommand, HeldOutChairsAreReconstructedToCentimetres) {
  ARMATURE_SHARED_DATA_OR_SKIP(table, "cad/keypointnet_chair_kp10.csv");
  const auto json = nlohmann::json::parse(Learn(Spec("chair") + " --annotations " + table.string() +
                                                " --format keypointnet_chair --held-out 4 --json"));
  EXPECT_EQ(json["models_read"], 682);
  EXPECT_EQ(json["training_models"], 406);
  EXPECT_EQ(json["held_out"][2]["modes"], 7);
  EXPECT_NEAR(json["held_out"][2]["midpoint_m"], 0.0139, 0.0005);
  EXPECT_NEAR(json["held_out"][2]["direction_deg"], 2.35, 0.1);
}

}  // namespace
}  // namespace armature
