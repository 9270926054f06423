// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "base/paired_difference.h"
#include "cli/compared_values.h"

namespace armature {
namespace {

// Each in a series of its own, or all in one; a = 10.
std::vector<ValuePair> PairsWithDifferences(const std::vector<double>& differences, bool is_series) {
  std::vector<ValuePair> pairs;
  for (size_t i = 0; i < differences.size(); ++i)
    pairs.push_back({is_series ? "" : std::to_string(i), 10, 10 + differences[i]});
  return pairs;
}

TEST(PairedDifference, OfNothingIsNone) { EXPECT_FALSE(ComparePairs({})); }

TEST(PairedDifference, OfEqualValuesIsZeroWithoutAMark) {
  const auto same = ComparePairs(PairsWithDifferences(std::vector<double>(20, 0), true)).value();
  EXPECT_EQ(same.median, 0);
  EXPECT_EQ(same.low, 0);
  EXPECT_EQ(same.high, 0);
  EXPECT_EQ(same.independent, 20);
  EXPECT_EQ(same.mark, DifferenceMark::kSame);
}

// Of 10 signs, 2 or less of one kind are met in 2 * 11 of 1024 cases: the second and the ninth value.
TEST(PairedDifference, IsBetweenTheRanksOfTheSignTest) {
  const auto sure = ComparePairs(PairsWithDifferences({4, 1, 10, 2, 9, 3, 8, 5, 7, 6}, false)).value();
  EXPECT_EQ(sure.n, 10u);
  EXPECT_DOUBLE_EQ(sure.median, 5.5);
  EXPECT_DOUBLE_EQ(sure.low, 2);
  EXPECT_DOUBLE_EQ(sure.high, 9);
  EXPECT_DOUBLE_EQ(sure.mean_b, 15.5);
  EXPECT_EQ(sure.mark, DifferenceMark::kHigher);
}

TEST(PairedDifference, IsMarkedOnlyBeyondItsInterval) {
  EXPECT_EQ(ComparePairs(PairsWithDifferences({-4, -1, -10, 2, -9, 3, -8, -5, -7, -6}, false))->mark,
            DifferenceMark::kSame);
  EXPECT_EQ(ComparePairs(PairsWithDifferences({-4, -1, -10, 2, -9, -3, -8, -5, -7, -6}, false))->mark,
            DifferenceMark::kLower);
  EXPECT_EQ(ComparePairs(PairsWithDifferences({1, 1, 1, 1, 1, 1}, false))->mark, DifferenceMark::kHigher);
  EXPECT_EQ(ComparePairs(PairsWithDifferences({1, 1, 1, 1, 1}, false))->mark, DifferenceMark::kTooFew);
}

// Five signs alike, then five of the other: of nine neighbours seven more agree than not.
TEST(PairedDifference, CountsAlikeNeighboursAsFewer) {
  const std::vector<double> drifting{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const auto series = ComparePairs(PairsWithDifferences(drifting, true)).value();
  EXPECT_NEAR(series.independent, 10 * (2.0 / 9) / (16.0 / 9), 1e-12);
  EXPECT_EQ(series.mark, DifferenceMark::kTooFew);
  EXPECT_EQ(series.low, 1);
  EXPECT_EQ(series.high, 10);
  EXPECT_EQ(ComparePairs(PairsWithDifferences(drifting, false))->independent, 10);
}

TEST(PairedDifference, OfRatiosIsComparedWithOne) {
  std::vector<ValuePair> pairs;
  for (int i = 1; i <= 8; ++i) pairs.push_back({"", 1.0 * i, 2.0 * i});
  const auto twice = ComparePairRatios(pairs).value();
  EXPECT_NEAR(twice.median, 2, 1e-12);
  EXPECT_NEAR(twice.low, 2, 1e-12);
  EXPECT_DOUBLE_EQ(twice.median_a, 4.5);
  EXPECT_EQ(twice.mark, DifferenceMark::kHigher);
}

TEST(ComparedValues, ArePairedByKeyAndCountWhatHasNoPartner) {
  const NamedValues a{"error [m]", 2, {{{"x"}, 1}, {{"y"}, 2}, {{"y", 100'000}, 3}}};
  const NamedValues b{"error [m]", 2, {{{"y"}, 2.5}, {{"z"}, 9}}};
  const auto compared = PairValues({{"of a alone", 2, {}}, a}, {b});
  ASSERT_EQ(compared.size(), 1u);
  ASSERT_EQ(compared[0].pairs.size(), 1u);
  EXPECT_EQ(compared[0].only_a, 2u);
  EXPECT_EQ(compared[0].only_b, 1u);
  EXPECT_EQ(RawPairRows("runs/b", "seq", compared), "runs/b,seq,error [m],y,,0,2,2.5,0.5\n");
  const Table table = DifferenceTable(compared);
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0][5].text, "0.50");
  EXPECT_EQ(table.rows[0][8].text, "too few");
}

TEST(ComparedValues, WithoutPairsAreARowOfDashes) {
  const Table table = DifferenceTable(PairValues({{"error", 2, {{{"x"}, 1}}}}, {{"error", 2, {}}}));
  EXPECT_EQ(table.rows.at(0).at(1).text, "");
  EXPECT_EQ(table.rows.at(0).at(10).text, "1");
}

}  // namespace
}  // namespace armature
