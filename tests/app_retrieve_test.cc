// SPDX-License-Identifier: BSD-3-Clause
// `armature retrieve` from end to end, on the small scene and a small library.
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <set>

#include "datasets/cad/collection_files.h"
#include "io/csv.h"
#include "io/mesh_file.h"
#include "io/placed_objects.h"
#include "support/filled_once.h"
#include "support/small_scene.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

using testing::CopySmallScene;
using testing::ExpectBadInput;
using testing::FilledOnce;
using testing::ProgramResult;
using testing::ReadFile;
using testing::RunOk;
using testing::RunProgram;
using testing::TempFolder;

constexpr size_t kInstances = 12;  // of each category in the small library

// The true instances of the small scene and others, tables and laptops.
void WriteSmallCollection(const std::filesystem::path& folder, const std::set<std::string>& wanted) {
  std::map<std::string, size_t> left = {{"table", kInstances}, {"laptop", kInstances}};
  std::vector<CadInstance> few;
  for (CadInstance& instance : DrawCollection({.chairs = 0, .tables = 170, .laptops = 170})) {
    const bool is_true = wanted.contains("armature:" + instance.id);
    size_t& others = left[instance.category];
    if (!is_true && others == 1) continue;
    if (!is_true) --others;
    few.push_back(std::move(instance));
  }
  std::filesystem::create_directories(folder);
  WriteCollection(few, folder);
}

// A finished run of the small scene, the CAD models and their library.
void FillWithSmallRun(const TempFolder& folder) {
  CopySmallScene(folder, 4);
  RunOk({"run", folder / "out/den", "--out", folder / "run", "--set", "mapping.min_observations=2"});
  std::set<std::string> instances;
  for (const TrueObject& object : LoadGroundTruth(folder / "out/den").objects)
    instances.insert(object.instance);
  WriteSmallCollection(folder / "cad", instances);
  RunOk({"retrieve", "--build", "--cad", folder / "cad", "--out", folder / "furniture.armlib"});
}

class RetrieveSmallScene : public ::testing::Test {
 protected:
  ProgramResult Retrieve(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"retrieve", run_, "--library", library_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunOk(arguments);
  }
  std::vector<std::string> InstancesOf(const std::string& object) const {
    std::vector<std::string> instances;
    const CsvTable table(run_ + "/retrieval.csv",
                         {"object", "rank", "instance", "distance", "cost", "scale"});
    for (const CsvRow& row : table.rows()) {
      if (row.Text("object") == object) instances.push_back(row.Text("instance"));
    }
    return instances;
  }

  static const TempFolder& SmallRun() {
    static FilledOnce small_run(FillWithSmallRun);
    return small_run.Restore();
  }

  const TempFolder& folder_ = SmallRun();
  std::string run_ = folder_ / "run", library_ = folder_ / "furniture.armlib";
};

TEST_F(RetrieveSmallScene, NamesAndPlacesTheNearestModels) {
  const std::string before = ReadFile(run_ + "/objects.csv");
  const ProgramResult result = Retrieve({"--place"});
  const std::vector<PlacedObject> objects = ReadPlacedObjects(run_ + "/objects.csv");
  ASSERT_FALSE(objects.empty());
  for (const PlacedObject& object : objects) {
    const std::vector<std::string> instances = InstancesOf(object.id);
    ASSERT_EQ(instances.size(), 5u);
    EXPECT_EQ(object.instance, instances.front());
    EXPECT_EQ(std::set<std::string>(instances.begin(), instances.end()).size(), 5u);
    EXPECT_NE(result.out.find(instances.back()), std::string::npos) << result.out;
  }
  // Nothing else of the map has changed.
  std::string without = ReadFile(run_ + "/objects.csv");
  for (const PlacedObject& object : objects)
    without.erase(without.find(object.instance), object.instance.size());
  EXPECT_EQ(without, before);

  EXPECT_GT(ReadMesh(run_ + "/map.ply").size(), 100);
  EXPECT_EQ(cv::imread(run_ + "/map.png").cols, 1600);

  const std::string csv = ReadFile(run_ + "/retrieval.csv");
  Retrieve();
  EXPECT_EQ(ReadFile(run_ + "/retrieval.csv"), csv);
}

TEST_F(RetrieveSmallScene, SaysWhatIsMissing) {
  std::filesystem::remove_all(folder_ / "cad/table");
  const ProgramResult placed =
      Retrieve({"--place", "--set", "retrieval.rerank=false", "--set", "retrieval.k=50"});
  EXPECT_NE(placed.err.find("table/table-"), std::string::npos) << placed.err;
  EXPECT_NE(placed.err.find("only its wireframe is shown"), std::string::npos) << placed.err;
  EXPECT_NE(placed.err.find("12 tables, fewer than retrieval.k = 50"), std::string::npos) << placed.err;
  EXPECT_EQ(InstancesOf("table0").size(), kInstances);

  std::filesystem::remove_all(folder_ / "out/den");
  Retrieve({"--set", "retrieval.rerank=false"});  // needs no images
  ExpectBadInput({"retrieve", run_, "--library", library_}, {"--sequence", "retrieval.rerank=false"});
}

TEST_F(RetrieveSmallScene, IsShownInAReport) {
  Retrieve();
  const std::string page = folder_ / "page/report.html";
  const std::vector<std::string> report{"report", run_, "--out", page};
  EXPECT_NE(
      RunOk({"report", run_, "--out", page, "--library", library_, "--title", "My <den>"}).out.find(page),
      std::string::npos);
  const std::string html = ReadFile(page);
  EXPECT_NE(html.find("My &lt;den&gt;"), std::string::npos);
  EXPECT_NE(html.find("Localization error on den"), std::string::npos) << "evaluated by the command";
  for (const std::string& instance : InstancesOf("table0"))
    EXPECT_NE(html.find(instance), std::string::npos) << instance;
  // An overlay each image and, of each object, the crop and five models.
  const size_t objects = ReadPlacedObjects(run_ + "/objects.csv").size();
  size_t pictures = 0;
  for (size_t at = html.find("data:image/jpeg;base64,"); at != std::string::npos;
       at = html.find("data:image/jpeg;base64,", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 4 + 6 * objects);
  RunOk({"report", run_, "--out", page, "--library", library_, "--title", "My <den>"});
  EXPECT_EQ(ReadFile(page), html);

  // What is not there is left out, and said.
  std::filesystem::remove_all(folder_ / "out/den");
  const ProgramResult bare = RunOk(report);
  EXPECT_NE(bare.err.find("no ground truth"), std::string::npos) << bare.err;
  EXPECT_NE(bare.err.find("--library"), std::string::npos) << bare.err;

  ExpectBadInput({"report", run_, "--out", page, "--eval", folder_ / "cad"}, {"eval.json", "armature eval"});
  folder_.Write("t.json", "[1");
  ExpectBadInput({"report", run_, "--out", page, "--table", folder_ / "t.json"}, {"t.json", "is not JSON"});
  ExpectBadInput({"report", run_, "--out", page, "--bench", folder_ / "cad"}, {"bench.json"});
}

TEST_F(RetrieveSmallScene, ARunOfOtherModelsIsRefused) {
  const std::string specs = std::string(ARMATURE_SOURCE_DIR) + "/configs/categories/specs/";
  for (const std::string category : {"table", "laptop"}) {
    RunOk({"learn", "--spec", specs + category + ".yaml", "--family", category, "--count", "60", "--out",
           folder_ / "other" / (category + ".yaml")});
  }
  const std::vector<std::string> other = {"--categories", folder_ / "other"};
  RunOk({"retrieve", "--build", "--cad", folder_ / "cad", "--out", library_, other[0], other[1]});
  ExpectBadInput({"retrieve", run_, "--library", library_, other[0], other[1]},
                 {"objects.csv", "the models that the run was made with", "--categories"});
}

TEST_F(RetrieveSmallScene, SavedIndicesAreUsedAndChecked) {
  const std::vector<std::string> plain = {"--set", "retrieval.rerank=false", "--set",
                                          "retrieval.covariance=false"};
  Retrieve(plain);
  const std::string csv = ReadFile(run_ + "/retrieval.csv");
  RunOk({"retrieve", "--build", "--cad", folder_ / "cad", "--out", library_, "--save-index"});
  const std::string index = library_ + ".table.index";
  ASSERT_TRUE(std::filesystem::exists(index));
  Retrieve(plain);
  EXPECT_EQ(ReadFile(run_ + "/retrieval.csv"), csv);
  folder_.Write("furniture.armlib.table.index", "spoilt");
  ExpectBadInput({"retrieve", run_, "--library", library_}, {index, "retrieve --build"});
  RunOk({"retrieve", "--build", "--cad", folder_ / "cad", "--out", library_});
  EXPECT_FALSE(std::filesystem::exists(index)) << "an index of an older library";
  Retrieve(plain);
}

TEST(RetrieveInput, BadUsageAndFiles) {
  const TempFolder folder;
  folder.Write("empty/readme.txt", "no CAD here");
  folder.Write("not_a_library", "text");
  folder.Write("run/summary.json", R"({"complete": true, "sequence": "den"})");
  const std::string run = folder / "run", file = folder / "not_a_library";
  ExpectBadInput({"retrieve"}, {"run folders", "--build"});
  ExpectBadInput({"retrieve", run}, {"--library", "--build"});
  ExpectBadInput({"retrieve", run, "--library", file}, {file, "not a library", "retrieve --build"});
  ExpectBadInput({"retrieve", run, "--library", folder / "absent"}, {"absent"});
  ExpectBadInput({"retrieve", "--build", "--out", folder / "a"}, {"--cad"});
  ExpectBadInput({"retrieve", "--build", "--cad", folder / "empty", "--out", folder / "a"},
                 {"empty", "annotated CAD"});
  ExpectBadInput({"retrieve", run, "--build", "--cad", folder / "empty", "--out", folder / "a"},
                 {"build first"});
  ExpectBadInput({"retrieve", run, "--library", file, "--save-index"}, {"--save-index"});
  ExpectBadInput({"retrieve", run, "--library", file, "--set", "retrieval.kk=3"},
                 {"retrieval.kk", "retrieval.k"});
  ExpectBadInput({"retrieve", run, "--library", file, "--set", "retrieval.index.kind=trie"},
                 {"trie", "kdtree"});
}

TEST(RetrieveInput, ALibraryOfOtherModelsOrWithoutInstancesIsRefused) {
  const TempFolder folder;
  WriteSmallCollection(folder / "cad", {});
  const std::string library = folder / "a.armlib";
  RunOk({"retrieve", "--build", "--cad", folder / "cad", "--out", library});
  RunOk({"learn", "--spec", std::string(ARMATURE_SOURCE_DIR) + "/configs/categories/specs/table.yaml",
         "--family", "table", "--count", "50", "--out", folder / "other/table.yaml"});
  folder.Write("run/summary.json", R"({"complete": true, "sequence": "den"})");
  ExpectBadInput({"retrieve", folder / "run", "--library", library, "--categories", folder / "other"},
                 {library, "another category model", "--categories"});
  RunOk({"learn", "--spec", std::string(ARMATURE_SOURCE_DIR) + "/configs/categories/specs/chair.yaml",
         "--family", "chair", "--count", "50", "--out", folder / "chairs/chair.yaml"});
  ExpectBadInput({"retrieve", folder / "run", "--library", library, "--categories", folder / "chairs"},
                 {library, "no instance of the categories chair"});
  ExpectBadInput({"retrieve", "--build", "--cad", folder / "cad", "--out", folder / "b", "--categories",
                  folder / "chairs"},
                 {"no annotated model of the categories chair"});
}

}  // namespace
}  // namespace armature
