// SPDX-License-Identifier: BSD-3-Clause
// The cheapest assignment: known ones, and all small random ones against trying everything.
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

#include "geometry/assignment.h"

namespace armature {
namespace {

using Columns = std::vector<int>;

// Number of pairs and sum of their prices.
struct Worth {
  int pairs = 0;
  double sum = 0;

  bool IsBetterThan(const Worth& other) const {
    return pairs != other.pairs ? pairs > other.pairs : sum < other.sum;
  }
};

Worth WorthOf(const Eigen::MatrixXd& costs, const Columns& columns) {
  Worth worth;
  for (size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] < 0) continue;
    ++worth.pairs;
    worth.sum += costs(static_cast<Eigen::Index>(i), columns[i]);
  }
  return worth;
}

// Rows from `row` on try every free column, and none.
void TryAll(const Eigen::MatrixXd& costs, size_t row, Columns& columns, Worth& best) {
  if (row == columns.size()) {
    const Worth worth = WorthOf(costs, columns);
    if (worth.IsBetterThan(best)) best = worth;
    return;
  }
  for (int j = -1; j < costs.cols(); ++j) {
    const auto end = columns.begin() + static_cast<std::ptrdiff_t>(row);
    if (j >= 0 && std::find(columns.begin(), end, j) != end) continue;
    if (j >= 0 && costs(static_cast<Eigen::Index>(row), j) == kForbidden) continue;
    columns[row] = j;
    TryAll(costs, row + 1, columns, best);
  }
  columns[row] = -1;
}

TEST(Hungarian, KnownAnswer) {
  Eigen::Matrix3d costs;
  costs << 4, 1, 3, 2, 0, 5, 3, 2, 2;
  EXPECT_EQ(Assign(costs), (Columns{1, 0, 2}));  // 1 + 2 + 2; row by row would take 1, then 2, then 2
}

TEST(Hungarian, TheNearestIsNotAlwaysBest) {
  Eigen::Matrix2d costs;
  costs << 1, 2, 1.5, 10;
  EXPECT_EQ(Assign(costs), (Columns{1, 0}));
}

TEST(Hungarian, MorePairsBeforeCheaperPairs) {
  Eigen::Matrix2d costs;
  costs << 0.1, 0.9, 0.9, kForbidden;
  EXPECT_EQ(Assign(costs), (Columns{1, 0})) << "two pairs of 0.9 each, not one of 0.1";
}

TEST(Hungarian, RowsAndColumnsThatStayAlone) {
  EXPECT_EQ(Assign(Eigen::RowVector3d(3, 1, 2)), (Columns{1}));
  EXPECT_EQ(Assign(Eigen::Vector3d(3, 1, 2)), (Columns{-1, 0, -1}));
  EXPECT_EQ(Assign(Eigen::Matrix2d::Constant(kForbidden)), (Columns{-1, -1}));
}

TEST(Hungarian, Empty) {
  EXPECT_EQ(Assign(Eigen::MatrixXd(0, 0)), Columns{});
  EXPECT_EQ(Assign(Eigen::MatrixXd(0, 3)), Columns{});
  EXPECT_EQ(Assign(Eigen::MatrixXd(2, 0)), (Columns{-1, -1}));
}

TEST(Hungarian, PricesAreNumbersFromZero) {
  EXPECT_THROW(Assign(Eigen::Matrix2d::Constant(-1)), std::invalid_argument);
  EXPECT_THROW(Assign(Eigen::Matrix2d::Constant(std::nan(""))), std::invalid_argument);
}

TEST(Hungarian, AsGoodAsTryingAll) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    Eigen::MatrixXd costs(1 + random() % 5, 1 + random() % 5);
    const auto forbidden_of_ten = random() % 11;
    for (double& cost : costs.reshaped()) {
      // Eighths: sums are exact, and ties are frequent.
      cost = random() % 10 < forbidden_of_ten ? kForbidden : static_cast<double>(random() % 17) / 8;
    }
    const Columns columns = Assign(costs);
    ASSERT_EQ(columns.size(), static_cast<size_t>(costs.rows()));
    std::multiset<int> used(columns.begin(), columns.end());
    for (int j = 0; j < costs.cols(); ++j) ASSERT_LE(used.count(j), 1u) << costs;
    Worth best;
    Columns tried(columns.size(), -1);
    TryAll(costs, 0, tried, best);
    const Worth worth = WorthOf(costs, columns);
    ASSERT_EQ(worth.pairs, best.pairs) << costs;
    ASSERT_EQ(worth.sum, best.sum) << costs;
  }
}

}  // namespace
}  // namespace armature
