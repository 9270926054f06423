// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/assignment.h"

#include <algorithm>
#include <stdexcept>

namespace armature {
namespace {

// Forbidden pairs at a price that no number of allowed ones reaches: to avoid one more of them is always
// cheaper, so that a least sum has the most allowed pairs.
Eigen::MatrixXd WithFinitePrices(const Eigen::MatrixXd& costs) {
  double dearest = 0;
  for (const double cost : costs.reshaped()) {
    if (!(cost >= 0)) throw std::invalid_argument("a price is negative or not a number");
    if (cost != kForbidden) dearest = std::max(dearest, cost);
  }
  const double forbidden = static_cast<double>(std::min(costs.rows(), costs.cols())) * dearest + 1;
  return costs.unaryExpr([&](double cost) { return cost == kForbidden ? forbidden : cost; });
}

// The Hungarian method with potentials, for at most as many rows as columns: rows are added one after the
// other, each by the cheapest path of changes that ends in a free column. Index 0 stands for "none" in all
// arrays, rows and columns count from 1.
class Hungarian {
 public:
  explicit Hungarian(const Eigen::MatrixXd& costs)
      : costs_(costs), rows_(Size(costs.rows())), columns_(Size(costs.cols())) {}

  // Each row's column.
  std::vector<int> Solve() {
    for (size_t row = 1; row < rows_; ++row) AddRow(row);
    std::vector<int> column_of(rows_ - 1, -1);
    for (size_t j = 1; j < columns_; ++j) {
      if (row_of_[j] != 0) column_of[row_of_[j] - 1] = static_cast<int>(j) - 1;
    }
    return column_of;
  }

 private:
  static size_t Size(Eigen::Index count) { return static_cast<size_t>(count) + 1; }

  double Reduced(size_t i, size_t j) const {
    return costs_(static_cast<Eigen::Index>(i) - 1, static_cast<Eigen::Index>(j) - 1) - of_row_[i] -
           of_column_[j];
  }

  // Dijkstra from the row to the nearest free column, by reduced prices.
  void AddRow(size_t row) {
    std::vector<double> distance(columns_, kForbidden);
    std::vector<size_t> before(columns_, 0);  // the column before this one on the path
    std::vector<bool> done(columns_, false);
    row_of_[0] = row;
    size_t column = 0;
    while (row_of_[column] != 0) {
      done[column] = true;
      const size_t from = column;
      double step = kForbidden;
      for (size_t j = 1; j < columns_; ++j) {
        if (done[j]) continue;
        const double reduced = Reduced(row_of_[from], j);
        if (reduced < distance[j]) {
          distance[j] = reduced;
          before[j] = from;
        }
        if (distance[j] < step) {
          step = distance[j];
          column = j;
        }
      }
      MovePotentials(step, done, distance);
    }
    for (; column != 0; column = before[column]) row_of_[column] = row_of_[before[column]];
  }

  void MovePotentials(double step, const std::vector<bool>& done, std::vector<double>& distance) {
    for (size_t j = 0; j < columns_; ++j) {
      if (done[j]) {
        of_row_[row_of_[j]] += step;
        of_column_[j] -= step;
      } else {
        distance[j] -= step;
      }
    }
  }

  const Eigen::MatrixXd& costs_;
  size_t rows_, columns_;  // with "none"
  std::vector<double> of_row_ = std::vector<double>(rows_, 0), of_column_ = std::vector<double>(columns_, 0);
  std::vector<size_t> row_of_ = std::vector<size_t>(columns_, 0);
};

// The columns of rows from the rows of columns.
std::vector<int> Inverted(const std::vector<int>& row_of, size_t rows) {
  std::vector<int> column_of(rows, -1);
  for (size_t j = 0; j < row_of.size(); ++j) {
    if (row_of[j] >= 0) column_of[static_cast<size_t>(row_of[j])] = static_cast<int>(j);
  }
  return column_of;
}

}  // namespace

std::vector<int> Assign(const Eigen::MatrixXd& costs) {
  const auto rows = static_cast<size_t>(costs.rows());
  if (costs.size() == 0) return std::vector<int>(rows, -1);
  const Eigen::MatrixXd prices = WithFinitePrices(costs);
  std::vector<int> column_of;
  if (prices.rows() <= prices.cols()) {
    column_of = Hungarian(prices).Solve();
  } else {
    const Eigen::MatrixXd turned = prices.transpose();
    column_of = Inverted(Hungarian(turned).Solve(), rows);
  }
  for (size_t i = 0; i < rows; ++i) {
    if (column_of[i] >= 0 && costs(static_cast<Eigen::Index>(i), column_of[i]) == kForbidden)
      column_of[i] = -1;
  }
  return column_of;
}

}  // namespace armature
