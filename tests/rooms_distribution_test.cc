// SPDX-License-Identifier: BSD-3-Clause
// What a recipe leaves to chance.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "datasets/rooms/distribution.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

class Distributions : public ::testing::Test {
 protected:
  YamlMap Load(const std::string& value) {
    return YamlMap::Load(folder_.Write("recipe.yaml", "# a comment\nx: " + value + "\n"));
  }
  Distribution Numbers(const std::string& value) { return ReadNumbers(Load(value), "x", -100, 100); }
  void ExpectError(const std::string& value, std::vector<std::string> texts) {
    texts.push_back("recipe.yaml:2:");
    testing::ExpectInputError([&] { Numbers(value); }, texts);
  }
  // Mean and standard deviation.
  std::pair<double, double> Moments(const Distribution& distribution) {
    double sum = 0, squares = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
      const double value = DrawNumber(distribution, random_);
      sum += value, squares += value * value;
    }
    const double mean = sum / kCount;
    return {mean, std::sqrt(squares / kCount - mean * mean)};
  }

  testing::TempFolder folder_;
  Random random_{1};
};

TEST_F(Distributions, OfAConstantIsTheConstant) { EXPECT_EQ(DrawNumber(Numbers("0.45"), random_), 0.45); }

TEST_F(Distributions, OfAListAreUniform) {
  for (const char* form : {"[2, 4]", "{uniform: [2, 4]}"}) {
    const auto [mean, deviation] = Moments(Numbers(form));
    EXPECT_NEAR(mean, 3, 0.02);
    EXPECT_NEAR(deviation, 2 / std::sqrt(12), 0.02);
  }
}

TEST_F(Distributions, OfANormalStayWithin) {
  const auto [mean, deviation] = Moments(Numbers("{normal: [5, 2]}"));
  EXPECT_NEAR(mean, 5, 0.05);
  EXPECT_NEAR(deviation, 2, 0.05);
  const Distribution cut = Numbers("{normal: [5, 2], within: [4, 5.5]}");
  for (int i = 0; i < 200; ++i) {
    const double value = DrawNumber(cut, random_);
    EXPECT_GE(value, 4);
    EXPECT_LE(value, 5.5);
  }
}

TEST_F(Distributions, OfAChoiceFollowTheWeights) {
  const Distribution words = ReadWords(Load("{choice: [a, b, c], weights: [1, 3, 0]}"), "x", {"a", "b", "c"});
  std::map<std::string, int> counts;
  for (int i = 0; i < 4000; ++i) ++counts[DrawWord(words, random_)];
  EXPECT_NEAR(counts["b"], 3000, 120);
  EXPECT_EQ(counts["c"], 0);
}

TEST_F(Distributions, OfAMixtureAreOfOneOfItsParts) {
  const Distribution mixture = Numbers(
      "{mixture: [{normal: [0.74, 0.02]}, {uniform: [0.4, 0.5]}, {choice: [1]}], weights: [17, 2, 1]}");
  int low = 0, high = 0;
  for (int i = 0; i < 4000; ++i) {
    const double value = DrawNumber(mixture, random_);
    low += value <= 0.5 ? 1 : 0;
    high += value == 1 ? 1 : 0;
  }
  EXPECT_NEAR(low, 400, 90);
  EXPECT_NEAR(high, 200, 70);
}

TEST_F(Distributions, OfWholeNumbersReachBothEnds) {
  std::map<int, int> counts;
  const Distribution chairs = Numbers("[6, 8]");
  for (int i = 0; i < 3000; ++i) ++counts[DrawInteger(chairs, random_)];
  EXPECT_EQ(counts.size(), 3U);
  for (const int n : {6, 7, 8}) EXPECT_NEAR(counts[n], 1000, 150);
}

TEST_F(Distributions, AreTheSameForTheSameStream) {
  const Distribution distribution = Numbers("{mixture: [{normal: [1, 2]}, {uniform: [3, 4]}]}");
  Random a(7), b(7);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(DrawNumber(distribution, a), DrawNumber(distribution, b));
}

TEST_F(Distributions, ReportWhatTheyCannotBe) {
  ExpectError("[4, 2]", {"'x'", "lesser first"});
  ExpectError("[4, 2, 3]", {"'x'", "3 values"});
  ExpectError("[4, 200]", {"'x'", "[-100, 100]"});
  ExpectError("abc", {"'x'", "'abc'", "numbers"});
  ExpectError("{}", {"'x'", "{normal: [mean, deviation]"});
  ExpectError("{normal: [1, -1]}", {"x.normal", "-1"});
  ExpectError("{normal: [1, 0.1], within: [5, 6]}", {"x.within", "mean 1"});
  ExpectError("{normal: [1, 0.1], weights: [1]}", {"weights"});
  ExpectError("{choice: [], weights: []}", {"empty"});
  ExpectError("{choice: [1, 2], weights: [1]}", {"x.weights", "1 numbers for 2"});
  ExpectError("{choice: [1, 2], weights: [0, 0]}", {"x.weights"});
  ExpectError("{choices: [1, 2]}", {"choices", "choice"});
  ExpectError("{mixture: [1, 2]}", {"mixture[0]", "map"});
  ExpectError("{mixture: [{normal: [1, 2]}], weights: [1, 1]}", {"x.weights"});
  testing::ExpectInputError([&] { ReadWords(Load("woof"), "x", {"wood", "tiles"}); }, {"woof", "wood"});
  testing::ExpectInputError([&] { ReadWords(Load("[1, 2]"), "x", {"wood"}); }, {"'x'", "words"});
}

}  // namespace
}  // namespace armature
