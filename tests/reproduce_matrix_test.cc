// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/reproduce/matrix_yaml.h"
#include "app/reproduce/read_matrix.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::TempFolder;

constexpr const char* kSmall = R"(name: small
data: generated
scenes: [seq1, seq2]
variants:
  - {name: objects, about: "with objects"}
  - {name: paper, preset: paper}
  - {name: odometry, odometry_of: objects}
timings:
  - {name: stages, sequences: [seq1, seq2], tables: [comparison]}
  - {name: instances, tables: [retrieval]}
retrieval: [objects]
fast: {frames: 5, timings: []}
)";

class ReproduceMatrix : public ::testing::Test {
 protected:
  Matrix Read(const std::string& yaml, bool fast = false) const {
    return ReadMatrix(folder_.Write("matrix.yaml", yaml), {.fast = fast});
  }
  // `text` in the small matrix replaced.
  Matrix ReadWith(const std::string& text, const std::string& by) const {
    std::string yaml = kSmall;
    yaml.replace(yaml.find(text), text.size(), by);
    return Read(yaml);
  }
  TempFolder folder_;
};

std::vector<std::string> NamesOfVariants(const Matrix& matrix) {
  std::vector<std::string> names;
  for (const Variant& variant : matrix.variants) names.push_back(variant.name);
  return names;
}

using Names = std::vector<std::string>;

TEST_F(ReproduceMatrix, TheShippedOneCanBeReadInFullAndFast) {
  const std::string file = std::string(ARMATURE_SOURCE_DIR) + "/configs/reproduce.yaml";
  const Matrix full = ReadMatrix(file, {}), fast = ReadMatrix(file, {.fast = true});
  EXPECT_EQ(full.frames, 0);
  EXPECT_GT(fast.frames, 0);
  EXPECT_NE(full.name, fast.name);
  EXPECT_NE(full.data, fast.data) << "or the pictures of one were rendered again for the other";
  EXPECT_EQ(NamesOfVariants(full), NamesOfVariants(fast));
}

TEST_F(ReproduceMatrix, TheAblationsAreAllVariants) {
  const std::filesystem::path configs = std::filesystem::path(ARMATURE_SOURCE_DIR) / "configs";
  const Names names = NamesOfVariants(ReadMatrix(configs / "ablations.yaml", {}));
  for (const auto& file : std::filesystem::directory_iterator(configs / "ablations")) {
    const std::string name = file.path().stem().string();
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST_F(ReproduceMatrix, FastReplacesWhatItNames) {
  EXPECT_EQ(Read(kSmall).timings.size(), 2u);
  const Matrix fast = Read(kSmall, true);
  EXPECT_EQ(fast.frames, 5);
  EXPECT_TRUE(fast.timings.empty());
  EXPECT_EQ(fast.scenes, (Names{"seq1", "seq2"}));
  ExpectInputError([&] { Read("scenes: [a]\ndata: d\nvariants: [{name: x}]\n", true); }, {"fast", "--fast"});
}

TEST_F(ReproduceMatrix, TheEffectiveOneIsReadAsTheSame) {
  Matrix matrix = Read(kSmall);
  matrix.categories = {{.name = "chair", .padding = {0.01, 0, 0.02}, .slab_drop = 0.1}};
  matrix.sequences = {"/my sequences/kitchen"};
  const std::string yaml = MatrixYaml(matrix);
  const Matrix again = Read(yaml);
  EXPECT_EQ(MatrixYaml(again), yaml);
  EXPECT_EQ(again.sequences, matrix.sequences);
  EXPECT_EQ(again.categories.at(0).padding, matrix.categories.at(0).padding);
  EXPECT_EQ(again.variants.at(2).odometry_of, "objects");
}

TEST_F(ReproduceMatrix, DrawsHaveNamesAndFoldersOfTheirOwn) {
  Matrix matrix = Read(kSmall);
  matrix.seeds = 2;
  matrix.data = "/d";
  matrix.sequences = {"/my/kitchen"};
  const std::vector<MatrixSequence> sequences = ListSequences(matrix);
  ASSERT_EQ(sequences.size(), 5u);
  EXPECT_EQ(sequences[0].folder, "/d/seq1");
  EXPECT_EQ(sequences[3].name, "seq2-draw2");
  EXPECT_EQ(sequences[3].family, "seq2");
  EXPECT_EQ(sequences[3].folder, "/d/draw2/seq2-draw2");
  EXPECT_EQ(sequences[4].folder, "/my/kitchen");
}

TEST_F(ReproduceMatrix, OnlyKeepsAllVariantsWhereNoneIsNamed) {
  Matrix matrix = Read(kSmall);
  KeepOnly({"seq2", "stages"}, matrix);
  EXPECT_EQ(matrix.scenes, Names{"seq2"});
  EXPECT_EQ(matrix.variants.size(), 3u);
  ASSERT_EQ(matrix.timings.size(), 1u);
  EXPECT_EQ(matrix.timings[0].sequences, Names{"seq2"});
}

TEST_F(ReproduceMatrix, OnlyTimingsThatAreNamedAreMade) {
  Matrix matrix = Read(kSmall);
  KeepOnly({"paper"}, matrix);
  EXPECT_EQ(matrix.scenes, (Names{"seq1", "seq2"}));
  EXPECT_TRUE(matrix.timings.empty());
}

TEST_F(ReproduceMatrix, OnlyAVariantPlacedByOdometryKeepsItsRun) {
  Matrix matrix = Read(kSmall);
  KeepOnly({"odometry"}, matrix);
  EXPECT_EQ(NamesOfVariants(matrix), (Names{"objects", "odometry"}));
  KeepOnly({"objects"}, matrix);
  EXPECT_EQ(NamesOfVariants(matrix), Names{"objects"});
}

TEST_F(ReproduceMatrix, OnlyAnUnknownNameIsRefused) {
  Matrix matrix = Read(kSmall);
  ExpectInputError([&] { KeepOnly({"seq4"}, matrix); }, {"--only", "'seq4'", "seq1"});
}

TEST_F(ReproduceMatrix, SequencesOfOnesOwnTakeThePlaceOfAll) {
  folder_.Write("mine/kitchen/sequence.yaml", "name: kitchen\n");
  folder_.Write("other/kitchen/sequence.yaml", "name: kitchen\n");
  Matrix matrix = Read(kSmall);
  ReplaceSequences({folder_ / "mine/kitchen/"}, matrix);
  ASSERT_EQ(ListSequences(matrix).size(), 1u);
  EXPECT_EQ(ListSequences(matrix)[0].folder, folder_.path() / "mine/kitchen");
  EXPECT_EQ(matrix.timings[0].sequences, Names{"kitchen"});
  EXPECT_TRUE(matrix.timings[1].sequences.empty()) << "it needs none";
  EXPECT_TRUE(matrix.retrieval.empty()) << "there are no CAD models";
  ExpectInputError([&] { ReplaceSequences({folder_ / "absent"}, matrix); }, {"absent", "sequence.yaml"});
  ExpectInputError(
      [&] {
        ReplaceSequences({folder_ / "mine/kitchen", folder_ / "other/kitchen"}, matrix);
      },
      {"other/kitchen", "name"});
}

TEST_F(ReproduceMatrix, OfVariantsAloneIsForSequencesOfOnesOwn) {
  const auto file = folder_.Write("matrix.yaml", "variants:\n  - {name: a}\n");
  ExpectInputError([&] { ReadMatrix(file, {}); }, {"matrix.yaml", "nothing to run"});
  folder_.Write("mine/kitchen/sequence.yaml", "name: kitchen\n");
  Matrix matrix = ReadMatrix(file, {.has_own_sequences = true});
  ReplaceSequences({folder_ / "mine/kitchen"}, matrix);
  EXPECT_EQ(FamilyNames(matrix), Names{"kitchen"});
  EXPECT_EQ(NamesOfVariants(matrix), Names{"a"});
}

TEST_F(ReproduceMatrix, SequencesMayEndWithASlash) {
  const Matrix matrix = ReadWith("scenes: [seq1, seq2]", "scenes: [seq1, seq2]\nsequences: [own/kitchen/]");
  EXPECT_EQ(FamilyNames(matrix), (Names{"seq1", "seq2", "kitchen"}));
}

// Results are found by the name in sequence.yaml, runs by the folder's.
TEST_F(ReproduceMatrix, TwoSequencesOfOneNameAreRefused) {
  const std::string yaml =
      "name: tiny\nfps: 5\ncamera: {width: 64, height: 48, fx: 60, fy: 60, cx: 31.5, cy: 23.5}\n";
  for (const std::string name : {"a", "b"}) folder_.Write(name + "/sequence.yaml", yaml);
  Matrix matrix = Read(kSmall);
  ReplaceSequences({folder_ / "a", folder_ / "b"}, matrix);
  ExpectInputError([&] { CheckNamesDiffer(matrix); }, {"/b: is called 'tiny'", "/a"});
  folder_.Write("b/sequence.yaml", "name: other" + yaml.substr(yaml.find('\n')));
  CheckNamesDiffer(matrix);
}

TEST_F(ReproduceMatrix, BadInputNamesFileLineAndKey) {
  ExpectInputError([&] { ReadWith("scenes:", "scene:"); }, {"matrix.yaml:3", "scenes"});
  ExpectInputError([&] { ReadWith("paper, preset", "objects, preset"); }, {"matrix.yaml", "'objects' twice"});
  ExpectInputError([&] { ReadWith("name: paper", "name: a/b"); }, {"matrix.yaml:6", "name", "slashes"});
  ExpectInputError([&] { ReadWith("odometry_of: objects", "odometry_of: object"); }, {"object", "objects"});
  ExpectInputError([&] { ReadWith("retrieval: [objects]", "retrieval: [odometry]"); },
                   {"matrix.yaml", "odometry"});
  ExpectInputError([&] { ReadWith("[seq1, seq2], tables", "[seq9], tables"); }, {"timings", "'seq9'"});
  ExpectInputError([&] { ReadWith("preset: paper", "config: absent.yaml"); }, {"config", "absent.yaml"});
  ExpectInputError([&] { ReadWith("data: generated", "seeds: 0"); }, {"seeds", "1 or more"});
  ExpectInputError([&] { ReadWith("data: generated", "frames: -1"); }, {"frames"});
  ExpectInputError([&] { ReadWith("data: generated\n", ""); }, {"data", "folder"});
  ExpectInputError([&] { ReadWith("scenes: [seq1, seq2]", "scenes: []"); }, {"nothing to run"});
  ExpectInputError([&] { ReadMatrix(folder_ / "absent.yaml", {}); }, {"absent.yaml"});
}

class ReproduceRooms : public ReproduceMatrix {
 protected:
  ReproduceRooms() { folder_.Write("mixed.yaml", "name: mixed\n"); }

  Matrix ReadRooms(const std::string& rooms, const std::string& more = "") const {
    return Read("data: d\nvariants: [{name: x}]\nrooms: {" + rooms + "}\n" + more);
  }
  void ExpectRefused(const std::string& rooms, const std::vector<std::string>& words) const {
    ExpectInputError([&] { ReadRooms(rooms); }, words);
  }
};

TEST_F(ReproduceRooms, AreSequencesByNumber) {
  const Matrix matrix = ReadRooms("recipe: mixed.yaml, count: 3, split: check");
  const std::vector<MatrixSequence> rooms = ListSequences(matrix);
  ASSERT_EQ(rooms.size(), 3u);
  EXPECT_EQ(rooms[2].name, "mixed-check-002");
  EXPECT_EQ(rooms[2].family, "mixed");
  EXPECT_EQ(rooms[2].folder.filename(), "mixed-check-002");
  EXPECT_EQ(rooms[2].folder.parent_path().filename(), "rooms");
  EXPECT_EQ(NameRoom({.name = "mixed", .split = "5"}, 1234), "mixed-5-1234");
  const Matrix furnished = ReadRooms("recipe: mixed.yaml, collections: [a/cad, b/], lines_only: true");
  EXPECT_EQ(ListSequences(furnished)[2].folder.parent_path().filename(), "rooms-cad-b-lines")
      << "rooms of one name, other furniture";
}

TEST_F(ReproduceRooms, TheEffectiveOneIsReadAsTheSame) {
  for (const std::string which : {"split: check", "seed: 9, lines_only: true"}) {
    const Matrix matrix =
        ReadRooms("recipe: mixed.yaml, count: 3, collections: [cad], " + which, "jitter: 2\n");
    EXPECT_EQ(matrix.jitter, 2);
    EXPECT_EQ(MatrixYaml(Read(MatrixYaml(matrix))), MatrixYaml(matrix));
    EXPECT_EQ(Read(MatrixYaml(matrix)).rooms->split, matrix.rooms->split);
  }
}

TEST_F(ReproduceRooms, BadInputNamesFileLineAndKey) {
  ExpectRefused("recipe: absent.yaml", {"absent.yaml"});
  ExpectRefused("recipe: mixed.yaml, count: 0", {"matrix.yaml:3", "count"});
  ExpectRefused("recipe: mixed.yaml, split: chekc", {"matrix.yaml:3", "split", "check"});
  ExpectRefused("recipe: mixed.yaml, split: check, seed: 3", {"matrix.yaml:3", "seed", "split"});
  ExpectRefused("recipe: mixed.yaml, seed: -1", {"matrix.yaml:3", "seed"});
  ExpectRefused("recipe: mixed.yaml, rooms: 3", {"matrix.yaml:3", "rooms"});
  folder_.Write("mixed.yaml", "name: a/b\n");
  ExpectRefused("recipe: mixed.yaml", {"mixed.yaml:1", "name"});
  folder_.Write("mixed.yaml", "about: nothing\n");
  ExpectRefused("recipe: mixed.yaml", {"mixed.yaml", "name"});
  ExpectInputError([&] { Read("data: d\nscenes: [a]\njitter: -1\nvariants: [{name: x}]\n"); },
                   {"matrix.yaml:3", "jitter"});
}

TEST_F(ReproduceRooms, TakeThePlaceOfAllSequencesAndTimings) {
  Matrix matrix = Read(kSmall);
  ReplaceByRooms({.name = "mixed", .count = 1}, matrix);
  EXPECT_EQ(FamilyNames(matrix), Names{"mixed"});
  EXPECT_TRUE(matrix.timings.empty());
  EXPECT_TRUE(matrix.retrieval.empty());
}

TEST_F(ReproduceMatrix, VariantsByNameAreItsOwnPresetsAndAblations) {
  const std::filesystem::path configs = std::filesystem::path(ARMATURE_SOURCE_DIR) / "configs";
  Matrix matrix = Read(kSmall);
  SelectVariants({"no_floor", "objects", "fast"}, configs, matrix);
  EXPECT_EQ(NamesOfVariants(matrix), (Names{"no_floor", "objects", "fast"}));
  EXPECT_EQ(matrix.variants[0].config, configs / "ablations/no_floor.yaml");
  EXPECT_EQ(matrix.variants[1].about, "with objects");
  EXPECT_EQ(matrix.variants[2].preset, "fast");
  EXPECT_EQ(matrix.retrieval, Names{"objects"});
  ExpectInputError([&] { SelectVariants({"no_flor"}, configs, matrix); }, {"--variants", "no_floor"});
  ExpectInputError([&] { SelectVariants({"fast", "fast"}, configs, matrix); }, {"--variants", "twice"});
  Matrix small = Read(kSmall);
  ExpectInputError([&] { SelectVariants({"odometry"}, configs, small); }, {"odometry", "objects"});
}

TEST_F(ReproduceMatrix, EachVariantRunsWithOtherDetectionsToo) {
  std::filesystem::create_directories(folder_ / "network");
  Matrix matrix = Read(kSmall);
  const Names before = NamesOfVariants(matrix);
  AddDetections({folder_ / "network/"}, matrix);
  Names all = before;
  for (const std::string& name : RunVariants(Read(kSmall))) all.push_back(name + "-network");
  EXPECT_EQ(NamesOfVariants(matrix), all);
  EXPECT_EQ(matrix.variants.back().detections, folder_ / "network");
  EXPECT_TRUE(matrix.variants.front().detections.empty());
  ExpectInputError([&] { AddDetections({folder_ / "absent"}, matrix); },
                   {"--detections", "absent", "<sequence>.csv"});
  ExpectInputError([&] { AddDetections({folder_ / "network"}, matrix); }, {"--detections", "rename"});
}

TEST_F(ReproduceMatrix, DetectionsOfAVariantAreAFolderBesideTheFile) {
  std::filesystem::create_directories(folder_ / "network");
  const Matrix matrix = ReadWith("preset: paper}", "detections: network}");
  EXPECT_EQ(matrix.variants[1].detections, folder_ / "network");
  EXPECT_EQ(MatrixYaml(Read(MatrixYaml(matrix))), MatrixYaml(matrix));
  ExpectInputError([&] { ReadWith("preset: paper}", "detections: absent}"); },
                   {"matrix.yaml:6", "detections"});
}

}  // namespace
}  // namespace armature
