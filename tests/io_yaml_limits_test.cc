// SPDX-License-Identifier: BSD-3-Clause
// YAML that a few bytes could make endless, and texts that no terminal should see.
#include <gtest/gtest.h>

#include "io/yaml_support.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

class YamlFile : public ::testing::Test {
 protected:
  YamlMap Load(const std::string& content) const { return YamlMap::Load(folder_.Write("a.yaml", content)); }
  void ExpectRefusedYaml(const std::string& content, const std::vector<std::string>& texts) const {
    testing::ExpectInputError([&] { Load(content); }, texts);
  }
  testing::TempFolder folder_;
};

TEST_F(YamlFile, AliasesStandForWhatTheyName) {
  const YamlMap map = Load("a: &x [1, 2]\nb: *x\nc: &y {d: 3}\ne: *y\n");
  EXPECT_EQ(map.Numbers("b"), (std::vector<double>{1, 2}));
  EXPECT_EQ(map.Map("e").Number("d"), 3);
}

TEST_F(YamlFile, AliasesInACircleAreRefused) {
  ExpectRefusedYaml("a: &a\n  x: *a\n", {"a.yaml:2", "inside of what it stands for"});
  ExpectRefusedYaml("a: &a [1, [*a]]\n", {"a.yaml:1", "inside of what it stands for"});
}

TEST_F(YamlFile, AliasesOfAliasesAreCountedWrittenOut) {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last;
    for (int k = 1; k < 10; ++k) text += ", " + last;
    text += "]\n";
  }
  ExpectRefusedYaml(text, {"a.yaml:6", "more than 200000 values"});
}

TEST_F(YamlFile, DepthIsLimitedAlsoThroughAliases) {
  ExpectRefusedYaml("a: " + std::string(100'000, '['), {"a.yaml:1", "levels deep"});
  std::string text = "a0: &a0 [[[[[[[[1]]]]]]]]\n";
  for (int i = 1; i < 12; ++i)
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [[[[[[[[*a" + std::to_string(i - 1) +
            "]]]]]]]]\n";
  ExpectRefusedYaml(text, {"a.yaml:", "levels deep"});
}

TEST_F(YamlFile, ASecondDocumentIsRefused) {
  ExpectRefusedYaml("a: 1\n---\nb: 2\n", {"a.yaml:", "second document"});
  EXPECT_EQ(Load("---\na: 1\n...\n").Number("a"), 1);
}

TEST_F(YamlFile, ControlCharactersAreRefusedInTheFileAndInItsTexts) {
  ExpectRefusedYaml("a: 1\nb: \x04\n", {"a.yaml:2", "control character"});
  ExpectRefusedYaml(std::string("a: 1\0\nb: 2\n", 12), {"a.yaml:1", "control character"});
  ExpectRefusedYaml("\"a\\e\": 1\n", {"a.yaml:1", "plain word"});
  for (const char* text : {"\"a\\e[31mred\"", "\"a\\nb\"", "\"a\\0b\"", "\"a\\x9bb\"", "\"a\\u202eb\""}) {
    const YamlMap map = Load("x: 1\nname: " + std::string(text) + "\n");
    testing::ExpectInputError([&] { map.Text("name"); }, {"a.yaml:2", "'name'", "plain word"});
  }
}

TEST_F(YamlFile, ATextMayStandBelowItsKeyOnOneLine) {
  EXPECT_EQ(Load("about: >\n  a chair\n  and a table\n").Text("about"), "a chair and a table");
}

TEST_F(YamlFile, AKeyGivenTwiceIsRefused) {
  ExpectRefusedYaml("a: 1\nb: 2\na: 3\n", {"a.yaml", "'a'", "twice"});
}

}  // namespace
}  // namespace armature
