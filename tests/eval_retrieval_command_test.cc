// SPDX-License-Identifier: BSD-3-Clause
// The tables of retrieval as users of `armature eval` get them, on the small scene and a small library.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "category/category_lookup.h"
#include "datasets/cad/collection_files.h"
#include "io/cad_folder.h"
#include "io/category_yaml.h"
#include "io/library_file.h"
#include "support/category_examples.h"
#include "support/filled_once.h"
#include "support/small_scene.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::RunOk;
using testing::TempFolder;
using Json = nlohmann::json;

// The named CAD models and some others.
void WriteFewModels(const std::filesystem::path& folder, const std::set<std::string>& wanted) {
  std::vector<CadInstance> few;
  for (CadInstance& instance : DrawCollection({.chairs = 0, .tables = 170, .laptops = 170})) {
    if (wanted.contains("armature:" + instance.id) || instance.id.ends_with("1"))
      few.push_back(std::move(instance));
  }
  std::filesystem::create_directories(folder);
  WriteCollection(few, folder);
}

// `without`: of these models.
void WriteLibraryOf(const std::filesystem::path& cad, const std::set<std::string>& without,
                    const std::filesystem::path& file) {
  const std::vector<CategoryModel> models = LoadCategories(testing::CategoryFolder());
  std::vector<CadModel> known = ReadCadFolder(cad, CollectSpecs(models));
  std::erase_if(known, [&](const CadModel& model) { return without.contains(model.instance); });
  WriteLibrary(BuildLibrary(models, known, cad), file);
}

// A finished run of the small scene, the CAD models and libraries with and without the true ones.
void FillWithRunAndLibraries(const TempFolder& folder) {
  testing::CopySmallScene(folder, 4);
  RunOk({"run", folder / "out/den", "--out", folder / "run", "--set", "mapping.min_observations=2"});
  std::set<std::string> true_models;
  for (const TrueObject& object : LoadGroundTruth(folder / "out/den").objects)
    true_models.insert(object.instance);
  WriteFewModels(folder / "cad", true_models);
  WriteLibraryOf(folder / "cad", {}, folder / "all.armlib");
  WriteLibraryOf(folder / "cad", true_models, folder / "others.armlib");
}

class EvalRetrievalCommand : public ::testing::Test {
 protected:
  static const TempFolder& RunAndLibraries() {
    static testing::FilledOnce folder(FillWithRunAndLibraries);
    return folder.Restore();
  }

  std::string Path(const std::string& name) const { return folder_ / name; }
  static Json Tables(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"eval", "--json"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return Json::parse(RunOk(all).out);
  }

  const TempFolder& folder_ = RunAndLibraries();
};

TEST_F(EvalRetrievalCommand, RanksTheTrueModelsOfARun) {
  const Json tables = Tables(
      {Path("run"), "--library", Path("all.armlib"), "--tables", "retrieval,retrieval_variants,each_query"});
  ASSERT_EQ(tables.size(), 3u);
  const Json& first = tables[0]["rows"][0];
  EXPECT_EQ(first["run"], "run");
  EXPECT_EQ(first["sequence"], "den");
  EXPECT_GE(first["in library"], 1);
  EXPECT_GT(first["by true shape"], 0.1);
  EXPECT_GE(first["ratio"], 0.5);
  EXPECT_GT(first["random"], first["by true shape"]);
  EXPECT_GE(tables[1]["rows"].size(), 9u);
  EXPECT_TRUE(tables[2]["rows"][0]["true model"].get<std::string>().starts_with("armature:"));
  EXPECT_LE(tables[2]["rows"][0]["rank re-ranked"], 10);
  EXPECT_NE(tables[2]["rows"][0]["first other"], tables[2]["rows"][0]["true model"]);
  const Json by_default = Tables({Path("run"), "--library", Path("all.armlib")});
  EXPECT_EQ(by_default.back(), tables[0]);
  EXPECT_GT(by_default.size(), 3u);
}

TEST_F(EvalRetrievalCommand, TrueModelsOutsideTheLibraryAreReadFromTheCadFolder) {
  const std::vector<std::string> command{Path("run"), "--library", Path("others.armlib"), "--tables",
                                         "retrieval"};
  const Json alone = Tables(command)[0]["rows"][0];
  EXPECT_EQ(alone["in library"], 0);
  EXPECT_EQ(alone["compared"], 0);
  EXPECT_EQ(alone["Chamfer [cm]"], nullptr);
  std::vector<std::string> with = command;
  with.insert(with.end(), {"--cad", Path("cad")});
  const Json known = Tables(with)[0]["rows"][0];
  EXPECT_EQ(known["in library"], 0);
  EXPECT_EQ(known["top-5 [%]"], nullptr);
  EXPECT_GE(known["compared"], 1);
  EXPECT_GT(known["Chamfer [cm]"], 0.1);
}

TEST_F(EvalRetrievalCommand, ALibraryAloneIsAskedForItsInstances) {
  const Json tables = Tables({"--library", Path("all.armlib"), "--every", "2", "--noise", "0"});
  ASSERT_EQ(tables.size(), 1u);
  const Json& whitened = tables[0]["rows"][1];
  EXPECT_EQ(whitened["variant"], "k-NN, whitened");
  EXPECT_EQ(whitened["top-1 [%]"], 100.0);
  EXPECT_EQ(whitened["ratio"], 1.0);
  const Json noisy = Tables({"--library", Path("all.armlib"), "--tables", "library", "--noise", "2"});
  EXPECT_LT(noisy[0]["rows"][1]["top-1 [%]"], 100.0);
}

TEST_F(EvalRetrievalCommand, BadInput) {
  const std::string run = Path("run"), library = Path("all.armlib");
  ExpectBadInput({"eval"}, {"no run", "--library"});
  ExpectBadInput({"eval", "--library", library, "--tables", "library,objects"}, {"no run"});
  ExpectBadInput({"eval", run, "--tables", "retrieval"}, {"--library", "armature retrieve --build"});
  ExpectBadInput({"eval", "--tables", "library"}, {"--library"});
  ExpectBadInput({"eval", run, "--library", Path("absent.armlib")}, {"absent.armlib"});
  ExpectBadInput({"eval", run + "/trajectory.txt", "--groundtruth", Path("out/den/groundtruth.txt"),
                  "--library", library},
                 {"--library", "trajectory"});
  ExpectBadInput({"eval", "--library", library, "--noise", "-1"}, {"--noise -1"});
  ExpectBadInput({"eval", "--library", library, "--every", "0"}, {"--every 0"});
  const std::vector<std::string> retrieval{"eval", run, "--library", library, "--tables", "retrieval"};
  const std::filesystem::path image = Path("out/den/rgb/0001.jpg"), evidence = run + "/shape_evidence.csv";
  ASSERT_TRUE(std::filesystem::exists(image));
  std::filesystem::rename(image, Path("image"));
  ExpectBadInput(retrieval, {"0001.jpg"});
  std::filesystem::rename(Path("image"), image);
  std::filesystem::rename(evidence, Path("evidence"));
  ExpectBadInput(retrieval, {"shape_evidence.csv", "armature run"});
  std::filesystem::rename(Path("evidence"), evidence);
}

}  // namespace
}  // namespace armature
