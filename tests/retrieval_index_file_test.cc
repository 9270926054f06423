// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <span>

#include "base/checksum.h"
#include "base/errors.h"
#include "geometry/random.h"
#include "io/index_file.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::ReadFile;
using testing::TempFolder;

IndexMethod SavedMethod(const std::string& name) {
  IndexMethod method;
  method.kind = *FromName<IndexKind>(name);
  return method;
}

Eigen::MatrixXf SavedFeatures(Eigen::Index count) {
  Random random(1);
  return Eigen::MatrixXf::NullaryExpr(7, count, [&] { return static_cast<float>(random.Normal(0, 1)); });
}

class SavedIndex : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(InstanceIndex, SavedIndex, ::testing::ValuesIn(ListNames<IndexKind>()),
                         [](const auto& test) { return test.param; });

// 8000 instances: more than FLANN's blocks of 64 KB, which it must read one after the other.
TEST_P(SavedIndex, AnswersAsTheOneThatWasBuilt) {
  const TempFolder folder;
  const IndexMethod method = SavedMethod(GetParam());
  for (const Eigen::Index count : {0, 1, 40, 8000}) {
    const Eigen::MatrixXf features = SavedFeatures(count);
    const InstanceIndex built(features, method);
    WriteIndex(built, folder / "index");
    const InstanceIndex loaded = ReadIndex(folder / "index", features, method);
    const Eigen::MatrixXf queries = SavedFeatures(20);
    for (const auto& query : queries.colwise()) {
      const Eigen::VectorXf beside = query.array() + 0.1F;
      ASSERT_EQ(loaded.Nearest(beside, 5), built.Nearest(beside, 5)) << count;
      ASSERT_EQ(loaded.Within(beside, 0.8), built.Within(beside, 0.8)) << count;
    }
    EXPECT_EQ(loaded.memory_bytes(), built.memory_bytes());
    WriteIndex(loaded, folder / "again");
    EXPECT_TRUE(ReadFile(folder / "again") == ReadFile(folder / "index")) << count;
  }
}

TEST_P(SavedIndex, ADamagedFileIsRefused) {
  const TempFolder folder;
  const Eigen::MatrixXf features = SavedFeatures(60);
  const IndexMethod method = SavedMethod(GetParam());
  WriteIndex(InstanceIndex(features, method), folder / "index");
  const std::string good = ReadFile(folder / "index");
  int files = 0;  // each a new one: to replace one waits for the disk
  const auto expect_refused = [&](const std::string& content) {
    const auto file = folder.Write("damaged" + std::to_string(++files), content);
    ExpectInputError([&] { ReadIndex(file, features, method); },
                     {file.filename(), "armature retrieve --build"});
  };
  for (size_t size = 0; size < good.size(); size += 1 + good.size() / 60)
    expect_refused(good.substr(0, size));
  for (size_t at = 0; at < good.size(); at += at < 200 ? 1 : good.size() / 100) {
    std::string flipped = good;
    flipped[at] = static_cast<char>(flipped[at] ^ 4);
    expect_refused(flipped);
  }
  expect_refused(good + '\n');
  expect_refused("");
  EXPECT_NO_THROW(ReadIndex(folder / "index", features, method));
}

// With a checksum that is right: the structure is refused, or one that can be searched.
TEST_P(SavedIndex, AnyByteChangedUnderARightChecksumIsRefusedOrDoesNoHarm) {
  const TempFolder folder;
  const Eigen::MatrixXf features = SavedFeatures(60);
  const IndexMethod method = SavedMethod(GetParam());
  WriteIndex(InstanceIndex(features, method), folder / "index");
  const std::string good = ReadFile(folder / "index");
  const size_t seal = good.find("payload "), start = good.find('\n', seal) + 1;
  const auto sealed = [&](const std::string& payload) {
    return good.substr(0, seal) +
           fmt::format("payload {} bytes, checksum {:016x}\n", payload.size(),
                       Checksum(std::as_bytes(std::span(payload)))) +
           payload;
  };
  const std::string payload = good.substr(start);
  ASSERT_EQ(sealed(payload), good);
  int files = 0, refused = 0;
  const auto read = [&](const std::string& changed) {
    const auto file = folder.Write("changed" + std::to_string(++files), sealed(changed));
    try {
      const InstanceIndex index = ReadIndex(file, features, method);
      for (const Neighbour& neighbour : index.Nearest(features.col(7), 5)) EXPECT_LT(neighbour.instance, 60);
    } catch (const InputError& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("armature retrieve --build"), std::string::npos);
    }
  };
  for (size_t at = 0; at < payload.size(); at += at < 200 ? 1 : 1 + payload.size() / 300) {
    for (const int bits : {1, 64, 255}) {
      std::string changed = payload;
      changed[at] = static_cast<char>(changed[at] ^ bits);
      read(changed);
    }
  }
  for (size_t size = 0; size < payload.size(); size += 1 + payload.size() / 50) read(payload.substr(0, size));
  read(payload + payload);
  EXPECT_GT(refused, 100);
}

TEST_P(SavedIndex, OtherFeaturesAreRefused) {
  const TempFolder folder;
  Eigen::MatrixXf features = SavedFeatures(60);
  WriteIndex(InstanceIndex(features, SavedMethod(GetParam())), folder / "index");
  const auto expect_refused = [&] {
    ExpectInputError([&] { ReadIndex(folder / "index", features, SavedMethod(GetParam())); },
                     {"other features", "armature retrieve --build"});
  };
  features(3, 17) += 1e-6F;
  expect_refused();
  features = SavedFeatures(59);
  expect_refused();
  features = SavedFeatures(60).reshaped(10, 42);
  expect_refused();
}

TEST(IndexFile, AnotherMethodOrOtherParametersAreRefused) {
  const TempFolder folder;
  const Eigen::MatrixXf features = SavedFeatures(60);
  IndexMethod method = SavedMethod("kdtree");
  WriteIndex(InstanceIndex(features, method), folder / "index");
  const auto expect_refused = [&](const IndexMethod& other, const std::string& shown) {
    ExpectInputError([&] { ReadIndex(folder / "index", features, other); },
                     {"another method", "kdtree trees=4 seed=1", shown});
  };
  expect_refused(SavedMethod("kmeans"), "kmeans");
  IndexMethod other = method;
  other.trees = 5;
  expect_refused(other, "trees=5");
  other = method;
  other.seed = 2;
  expect_refused(other, "seed=2");
  method.checks = 7;  // not of the structure
  EXPECT_NO_THROW(ReadIndex(folder / "index", features, method));
}

TEST(IndexFile, AnotherVersionIsRefused) {
  const TempFolder folder;
  const Eigen::MatrixXf features = SavedFeatures(6);
  WriteIndex(InstanceIndex(features, {}), folder / "index");
  std::string content = ReadFile(folder / "index");
  content.replace(content.find(" 1,"), 3, " 2,");
  folder.Write("index", content);
  ExpectInputError([&] { ReadIndex(folder / "index", features, {}); },
                   {"another version", "armature-index 2"});
}

TEST(IndexFile, AMissingOneIsNamed) {
  const TempFolder folder;
  ExpectInputError([&] { ReadIndex(folder / "none", SavedFeatures(6), {}); }, {"none", "exists"});
}

TEST(IndexFile, AFolderThatIsNotThereIsAnError) {
  const TempFolder folder;
  EXPECT_THROW(WriteIndex(InstanceIndex(SavedFeatures(6), {}), "/proc/none/index"), InputError);
}

TEST(InstanceIndex, RefusesParametersOutOfRange) {
  const auto expect_refused = [](auto change, const std::vector<std::string>& shown) {
    IndexMethod method;
    change(method);
    ExpectInputError([&] { InstanceIndex(SavedFeatures(6), method); }, shown);
  };
  expect_refused([](IndexMethod& m) { m.leaf_size = 0; }, {"leaf_size 0", "1 or more"});
  expect_refused([](IndexMethod& m) { m.trees = 0; }, {"trees 0"});
  expect_refused([](IndexMethod& m) { m.branching = 1; }, {"branching 1", "2 or more"});
  expect_refused([](IndexMethod& m) { m.iterations = 0; }, {"iterations 0"});
  expect_refused([](IndexMethod& m) { m.checks = 0; }, {"checks 0"});
}

TEST(InstanceIndex, MistakesOfTheCallerAreLoud) {
  const InstanceIndex index(SavedFeatures(6), {});
  EXPECT_THROW(index.Nearest(Eigen::VectorXf::Zero(6), 5), std::invalid_argument);
  EXPECT_THROW(index.Within(Eigen::VectorXf::Zero(8), 5), std::invalid_argument);
  EXPECT_THROW(index.Nearest(Eigen::VectorXf::Zero(7), 0), std::invalid_argument);
  EXPECT_THROW(InstanceIndex(Eigen::MatrixXf(0, 3), {}), std::invalid_argument);
  EXPECT_THROW(InstanceIndex(Eigen::MatrixXf::Constant(2, 3, NAN), {}), std::invalid_argument);
}

}  // namespace
}  // namespace armature
