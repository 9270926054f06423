// SPDX-License-Identifier: BSD-3-Clause
#include "io/category_yaml.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/category_spec_yaml.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::CategoryFolder;
using testing::ExpectInputError;
using testing::ReadFile;
using testing::TempFolder;

const char* const kCategories[] = {"chair", "laptop", "table"};

TEST(CategoryYaml, RoundTripIsExact) {
  const TempFolder folder;
  for (const char* name : kCategories) {
    const CategoryModel model = LoadCategory(CategoryFolder() / fmt::format("{}.yaml", name));
    const auto file = folder / name;
    WriteCategory(model, file);
    const CategoryModel again = LoadCategory(file);
    EXPECT_EQ(again.mean, model.mean);
    EXPECT_EQ(again.basis, model.basis);
    EXPECT_EQ(again.standard_deviations, model.standard_deviations);
    EXPECT_EQ(again.total_variance, model.total_variance);
    EXPECT_EQ(again.dictionary, model.dictionary);
    EXPECT_EQ(again.source, model.source);
    EXPECT_EQ(CategoryText(again), ReadFile(file));
  }
}

TEST(CategoryYaml, ShippedModelsCarryTheSpecificationTheyAreShippedWith) {
  for (const char* name : kCategories) {
    const std::string file = fmt::format("{}.yaml", name);
    CategoryModel model = LoadCategory(CategoryFolder() / file);
    const std::string with_own = CategoryText(model);
    model.spec = LoadCategorySpec(CategoryFolder() / "specs" / file);
    EXPECT_EQ(CategoryText(model), with_own) << "learn " << name << " again";
  }
}

TEST(CategoryYaml, ADirectoryIsReadSortedByName) {
  const std::vector<CategoryModel> models = LoadCategories(CategoryFolder());
  ASSERT_EQ(models.size(), 3u);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(models[i].spec.name, kCategories[i]);
}

TEST(CategoryYaml, DirectoriesWithoutOrWithTwoModelsOfACategoryAreRefused) {
  const TempFolder folder;
  ExpectInputError([&] { LoadCategories(folder.path()); }, {folder.path().string(), "armature learn"});
  const std::string text = ReadFile(CategoryFolder() / "table.yaml");
  folder.Write("a.yaml", text);
  folder.Write("b.yaml", text);
  ExpectInputError([&] { LoadCategories(folder.path()); }, {"b.yaml", "'table'"});
}

TEST(CategoryYaml, WritingCreatesTheFoldersAroundTheFile) {
  const CategoryModel model = LoadCategory(CategoryFolder() / "table.yaml");
  const TempFolder folder;
  const auto file = folder / "new/models/table.yaml";
  WriteCategory(model, file);
  EXPECT_EQ(ReadFile(file), CategoryText(model));
}

TEST(CategoryYaml, WritingWhereAFileIsInTheWayIsAnError) {
  const CategoryModel model = LoadCategory(CategoryFolder() / "table.yaml");
  const TempFolder folder;
  folder.Write("notes", "no folder");
  ExpectInputError([&] { WriteCategory(model, folder / "notes/table.yaml"); },
                   {"notes/table.yaml", "folder"});
}

// The table's specification with another value of a key, or without it.
std::string TableSpecWith(const std::string& key, const std::string& value) {
  std::string text = ReadFile(CategoryFolder() / "specs/table.yaml");
  const size_t at = text.find("\n" + key + ":");
  return text.replace(at, text.find('\n', at + 1) - at, value.empty() ? "" : "\n" + key + ": " + value);
}

TEST(CategoryYaml, PaddingIsOneLengthOrOneForEachAxis) {
  const TempFolder folder;
  const auto padding = [&](const std::string& value) {
    return LoadCategorySpec(folder.Write("spec.yaml", TableSpecWith("padding", value))).padding;
  };
  EXPECT_EQ(padding("0.02"), Eigen::Vector3d(0.02, 0.02, 0.02));
  EXPECT_EQ(padding("[0.01, 0.02, 0]"), Eigen::Vector3d(0.01, 0.02, 0));
  EXPECT_EQ(padding(""), Eigen::Vector3d(0, 0, 0));
  for (const char* bad : {"[0.01, 0.02]", "[0.01, 0.02, 0, 0]", "[]", "-0.01", "[0.01, -0.02, 0]"})
    ExpectInputError([&] { padding(bad); }, {"spec.yaml:20", "padding", "[x, y, z]"});
  ExpectInputError([&] { padding("[0.01, wide, 0]"); }, {"spec.yaml:20", "padding", "wide"});
}

TEST(CategoryYaml, HowMuchSizesDifferIsPositive) {
  const TempFolder folder;
  const auto size_sigma = [&](const std::string& value) {
    return LoadCategorySpec(folder.Write("spec.yaml", TableSpecWith("size_sigma", value))).size_sigma;
  };
  EXPECT_EQ(size_sigma("0.2"), 0.2);
  EXPECT_EQ(size_sigma(""), CategorySpec{}.size_sigma);
  for (const char* bad : {"0", "-0.1"})
    ExpectInputError([&] { size_sigma(bad); }, {"spec.yaml", "size_sigma"});
}

TEST(CategoryYaml, ASlabIsReadAndWrittenWhereItIsUsed) {
  const TempFolder folder;
  const auto spec = [&](const std::string& from, const std::string& to) {
    std::string text = ReadFile(CategoryFolder() / "specs/table.yaml");
    text.replace(text.find(from), from.size(), to);
    return LoadCategorySpec(folder.Write("spec.yaml", text));
  };
  const CategorySpec table = spec("drop: 0", "drop: 0.02");
  ASSERT_TRUE(table.slab);
  EXPECT_EQ(table.slab->edges, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(table.slab->drop, 0.02);
  EXPECT_NE(CategorySpecText(table).find("drop: 0.02"), std::string::npos);
  EXPECT_EQ(CategorySpecText(spec("drop: 0", "drop: 0")).find("slab"), std::string::npos);
  ExpectInputError([&] { spec("drop: 0", "drop: -0.02"); }, {"spec.yaml", "slab.drop", "at least 0"});
  ExpectInputError(
      [&] { spec("[top_rear, top_right, top_front, top_left]\n  drop", "[top_rear, top_right]\n  drop"); },
      {"spec.yaml", "slab.edges", "at least 3"});
  ExpectInputError([&] { spec("top_left]\n  drop", "top_lift]\n  drop"); }, {"spec.yaml", "top_lift"});
}

// Reads the shipped file with the first occurrence of `from` replaced.
void ExpectRefused(const std::string& file, const std::string& from, const std::string& to,
                   const std::vector<std::string>& texts) {
  SCOPED_TRACE(to);
  std::string content = ReadFile(CategoryFolder() / file);
  const size_t at = content.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  content.replace(at, from.size(), to);
  const TempFolder folder;
  const auto changed = folder.Write("changed.yaml", content);
  ExpectInputError(
      [&] {
        file.find("specs") == 0 ? static_cast<void>(LoadTrainingSpec(changed))
                                : static_cast<void>(LoadCategory(changed));
      },
      texts);
}

TEST(CategoryYaml, BadSpecificationsAreNamedWithTheirLine) {
  const std::string chair = "specs/chair.yaml";
  ExpectRefused(chair, "category: chair", "category: a chair", {"changed.yaml:5", "'a chair'"});
  ExpectRefused(chair, "- back_left", "- back_top", {"changed.yaml:6", "'back_top' twice"});
  ExpectRefused(chair, "[seat_left, seat_rear]", "[seat_left]", {"changed.yaml:", "base_edges", "two edges"});
  ExpectRefused(chair, "[seat_left, seat_rear]", "[seat_lefft, seat_rear]", {"seat_lefft", "seat_left"});
  std::string many = "back_top.start";
  for (int i = 0; i < kMaxFaceCorners; ++i) many += ", back_top.end";
  ExpectRefused(chair, "back_top.start", many, {"changed.yaml:", "more than 16 corners"});
  ExpectRefused(chair, "back_top.start", "back_top.begin", {"'back_top.begin'", "EDGE.start"});
  ExpectRefused(chair, "height_above_ground", "height", {"'height'", "height_above_ground or length"});
  ExpectRefused(chair, "metres: 0.45", "metres: -0.45", {"reference.metres", "positive"});
  ExpectRefused(chair, "symmetry_order: 1", "symmetry_order: 0", {"symmetry_order", "at least 1"});
  ExpectRefused(chair, "stands_on_floor: true", "stands_on_flor: true",
                {"stands_on_flor", "stands_on_floor"});
  ExpectRefused(chair, "modes: 7", "modes: 700", {"training.modes", "700"});
  ExpectRefused(chair, "[0.35, 0.70]", "[0.70, 0.35]", {"training.plausible.width", "[least, greatest]"});
}

TEST(CategoryYaml, BadModelsAreNamedWithTheirLine) {
  const std::string laptop = "laptop.yaml";
  ExpectRefused(laptop, "[base_left, hinge]", "[hinge, base_left]", {"changed.yaml:7", "point up"});
  ExpectRefused(laptop, "standard_deviations: [", "standard_deviations: [1, ",
                {"model.basis", "4 modes for 5"});
  ExpectRefused(laptop, "standard_deviations: [", "standard_deviations: [-", {"have to be positive"});
  ExpectRefused(laptop, "total_variance: 0", "total_variance: -1", {"total_variance", "less than"});
  ExpectRefused(laptop, "    hinge: [0, ", "    hinge: [", {"model.mean.hinge", "5 numbers where 6"});
  ExpectRefused(laptop, "    hinge: [0, ", "    hinge: [x, ", {"changed.yaml:", "'x'"});
  ExpectRefused(laptop, "mode_2:", "mode_9:", {"model.basis.mode_2", "missing"});
  ExpectRefused(laptop, "      screen_top: [0, ", "      screen_top: [0.5, ", {"model.basis", "orthonormal"});
  ExpectRefused(laptop, "    model_1: [", "    model_1: [0, ",
                {"model.dictionary.model_1", "5 numbers where 4"});
}

TEST(CategoryYaml, ASpecificationIsNoModel) {
  ExpectInputError([] { LoadCategory(CategoryFolder() / "specs" / "chair.yaml"); },
                   {"specs/chair.yaml", "model", "armature learn"});
}

}  // namespace
}  // namespace armature
