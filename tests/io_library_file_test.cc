// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "base/checksum.h"
#include "io/library_file.h"
#include "support/expect_input_error.h"
#include "support/frame_library.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

using testing::ExpectInputError;
using testing::FrameInstances;
using testing::FrameModel;
using testing::ReadFile;
using testing::SomeCoefficients;
using testing::TempFolder;

CategoryModel Gates() {
  CategoryModel model = FrameModel();
  model.spec.name = "gate";
  model.mean *= 2;
  return model;
}

InstanceLibrary TwoCategories(const fs::path& root) {
  CategoryInstances gates = FrameInstances(SomeCoefficients(2));
  gates.category = "gate";
  gates.model_checksum = ModelChecksum(Gates());
  gates.ids[0] = "a name with blanks, commas and \xc3\xa4";
  gates.geometries[1] = "";
  return {root, {FrameInstances(SomeCoefficients(7)), gates}};
}

void ExpectSame(const CategoryInstances& a, const CategoryInstances& b) {
  EXPECT_EQ(a.category, b.category);
  EXPECT_EQ(a.model_checksum, b.model_checksum);
  EXPECT_EQ(a.ids, b.ids);
  EXPECT_EQ(a.geometries, b.geometries);
  EXPECT_EQ(a.coefficients, b.coefficients);
  EXPECT_EQ(a.sizes, b.sizes);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.size_sigmas, b.size_sigmas);
  EXPECT_EQ(a.T_object_geometry, b.T_object_geometry);
}

TEST(LibraryFile, ComesBackBitByBit) {
  const TempFolder folder;
  const InstanceLibrary library = TwoCategories(folder / "cad");
  WriteLibrary(library, folder / "library");
  const InstanceLibrary read = ReadLibrary(folder / "library", {FrameModel(), Gates()});
  ASSERT_EQ(read.categories.size(), 2);
  ExpectSame(read.categories[0], library.categories[0]);
  ExpectSame(read.categories[1], library.categories[1]);
  EXPECT_EQ(read.root, folder / "cad");
  WriteLibrary(read, folder / "again");
  EXPECT_TRUE(ReadFile(folder / "again") == ReadFile(folder / "library"));
}

TEST(LibraryFile, AnEmptyLibraryComesBack) {
  const TempFolder folder;
  WriteLibrary({folder.path(), {}}, folder / "library");
  EXPECT_TRUE(ReadLibrary(folder / "library", {FrameModel()}).categories.empty());
}

TEST(LibraryFile, ItsRootMovesWithIt) {
  const TempFolder folder;
  WriteLibrary(TwoCategories(folder / "old/data/cad"), folder / "old/runs/library");
  fs::rename(folder / "old", folder / "new");
  EXPECT_EQ(ReadLibrary(folder / "new/runs/library", {FrameModel()}).root, folder / "new/data/cad");
}

TEST(LibraryFile, CategoriesWithoutModelAreLeftOut) {
  const TempFolder folder;
  WriteLibrary(TwoCategories(folder.path()), folder / "library");
  const InstanceLibrary read = ReadLibrary(folder / "library", {Gates()});
  ASSERT_EQ(read.categories.size(), 1);
  EXPECT_EQ(read.categories[0].category, "gate");
}

TEST(LibraryFile, AnotherModelsCoefficientsAreRefused) {
  const TempFolder folder;
  WriteLibrary(TwoCategories(folder.path()), folder / "library");
  CategoryModel learnt_again = Gates();
  learnt_again.standard_deviations *= 1.01;
  ExpectInputError(
      [&] {
        ReadLibrary(folder / "library", {FrameModel(), learnt_again});
      },
      {"library", "gate", "another category model", "--categories", "armature retrieve --build"});
}

class BadLibraryFile : public ::testing::Test {
 protected:
  BadLibraryFile() {
    WriteLibrary(TwoCategories(folder_.path()), folder_ / "library");
    good_ = ReadFile(folder_ / "library");
  }
  // Each file is a new one: to replace one waits for the disk.
  void ExpectRefused(const std::string& content, const std::string& text = "") {
    const fs::path file = folder_.Write("bad" + std::to_string(++files_), content);
    ExpectInputError(
        [&] {
          ReadLibrary(file, {FrameModel(), Gates()});
        },
        {file.filename(), text, "armature retrieve --build"});
  }

  TempFolder folder_;
  std::string good_;

 private:
  int files_ = 0;
};

TEST_F(BadLibraryFile, Missing) {
  ExpectInputError([&] { ReadLibrary(folder_ / "nowhere", {}); }, {"nowhere", "cannot be opened"});
}

TEST_F(BadLibraryFile, SomethingElse) {
  ExpectRefused("", "is not a library of instances");
  ExpectRefused("ply\nformat ascii 1.0\n", "is not a library of instances");
}

TEST_F(BadLibraryFile, OfAnotherVersion) {
  std::string newer = good_;
  newer[newer.find('\n') + 1] = 7;
  ExpectRefused(newer, "is of version 7, not 1");
}

TEST_F(BadLibraryFile, CutShort) {
  for (size_t size = 0; size < good_.size(); size += size < 60 ? 1 : 37) ExpectRefused(good_.substr(0, size));
  ExpectRefused(good_.substr(0, good_.size() - 1), "cut short");
  ExpectRefused(good_ + '\0', "damaged");
}

TEST_F(BadLibraryFile, AnyByteChanged) {
  for (size_t at = 0; at < good_.size(); at += at < 120 ? 1 : 11) {
    std::string flipped = good_;
    flipped[at] = static_cast<char>(flipped[at] ^ 16);
    ExpectRefused(flipped);
  }
}

// With a checksum that is right: nothing that it says is believed before it is looked at.
TEST_F(BadLibraryFile, AnyNumberChangedUnderARightChecksum) {
  const auto sealed = [](std::string content) {
    content.resize(content.size() - sizeof(std::uint64_t));
    const std::uint64_t sum = Checksum(std::as_bytes(std::span(content)));
    content.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    return content;
  };
  ASSERT_EQ(sealed(good_), good_);
  const size_t header = good_.find("frame") == std::string::npos ? 120 : good_.find("frame") + 60;
  for (const std::uint64_t absurd : {~std::uint64_t{0}, std::uint64_t{1} << 63, std::uint64_t{1} << 62,
                                     std::uint64_t{1} << 40, std::uint64_t{0}}) {
    for (size_t at = good_.find('\n') + 5; at + sizeof absurd < std::min(header, good_.size()); ++at) {
      std::string content = good_;
      content.replace(at, sizeof absurd, reinterpret_cast<const char*>(&absurd), sizeof absurd);
      const fs::path file = folder_.Write("absurd" + std::to_string(at), sealed(content));
      try {
        ReadLibrary(file, {FrameModel(), Gates()});
      } catch (const InputError&) {
      }
    }
  }
}

TEST_F(BadLibraryFile, OfNumbersThatCannotBe) {
  const auto refuse = [&](const auto& spoil, const std::string& text) {
    InstanceLibrary library = TwoCategories(folder_.path());
    spoil(library);
    WriteLibrary(library, folder_ / "spoilt");
    ExpectRefused(ReadFile(folder_ / "spoilt"), text);
  };
  refuse([](InstanceLibrary& library) { library.categories[0].edges(2, 1) = NAN; }, "not finite");
  refuse([](InstanceLibrary& library) { library.categories[0].sizes(1, 1) = -1; }, "below zero");
  refuse([](InstanceLibrary& library) { library.categories[0].coefficients.conservativeResize(1, 7); },
         "other shapes");
  refuse([](InstanceLibrary& library) { library.categories.push_back(library.categories[0]); }, "twice");
}

TEST_F(BadLibraryFile, WhereNoneCanBeWritten) {
  const auto entries = [&] { return std::distance(fs::directory_iterator(folder_.path()), {}); };
  const auto before = entries();
  ExpectInputError(
      [&] {
        WriteLibrary({folder_.path(), {}}, folder_ / "library/below");
      },
      {"library/below", "cannot be written"});
  EXPECT_EQ(entries(), before);
  EXPECT_EQ(ReadFile(folder_ / "library"), good_);
}

}  // namespace
}  // namespace armature
