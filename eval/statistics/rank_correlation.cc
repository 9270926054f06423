// SPDX-License-Identifier: BSD-3-Clause
#include "eval/statistics/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/statistics.h"

namespace armature {
namespace {

constexpr long kFewestPairs = 3;

std::vector<size_t> OrderBy(const std::vector<PairInRoom>& pairs, double PairInRoom::*value) {
  std::vector<size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return pairs[a].*value < pairs[b].*value; });
  return order;
}

// Of the values the one up to which the share of them is nearest; of growing values.
double NearestBound(const std::vector<double>& values, double share) {
  const double wanted = share * static_cast<double>(values.size());
  double bound = values.back(), nearest = HUGE_VAL;
  for (size_t i = 0; i < values.size(); ++i) {
    if (i + 1 < values.size() && values[i + 1] == values[i]) continue;
    const double off = std::abs(static_cast<double>(i + 1) - wanted);
    if (off < nearest) bound = values[i];
    nearest = std::min(nearest, off);
  }
  return bound;
}

}  // namespace

RankCorrelation::RankCorrelation(const std::vector<PairInRoom>& pairs)
    : pairs_(pairs), by_x_(OrderBy(pairs, &PairInRoom::x)), by_y_(OrderBy(pairs, &PairInRoom::y)) {}

// Each pair counts as often as its room was drawn.
std::vector<double> RankCorrelation::Ranks(const std::vector<size_t>& order, double PairInRoom::*value,
                                           const RoomCounts& counts) const {
  std::vector<double> ranks(pairs_.size());
  double before = 0;
  for (size_t first = 0; first < order.size();) {
    size_t last = first;
    double equal = 0;
    for (; last < order.size() && pairs_[order[last]].*value == pairs_[order[first]].*value; ++last)
      equal += counts[pairs_[order[last]].room];
    for (; first < last; ++first) ranks[order[first]] = before + (equal + 1) / 2;
    before += equal;
  }
  return ranks;
}

std::optional<double> RankCorrelation::Of(const RoomCounts& counts) const {
  const std::vector<double> x = Ranks(by_x_, &PairInRoom::x, counts),
                            y = Ranks(by_y_, &PairInRoom::y, counts);
  long n = 0;
  for (const PairInRoom& pair : pairs_) n += counts[pair.room];
  if (n < kFewestPairs) return std::nullopt;
  const double mean = (static_cast<double>(n) + 1) / 2;
  double xx = 0, yy = 0, xy = 0;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const double weight = counts[pairs_[i].room], dx = x[i] - mean, dy = y[i] - mean;
    xx += weight * dx * dx;
    yy += weight * dy * dy;
    xy += weight * dx * dy;
  }
  if (xx <= 0 || yy <= 0) return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

std::optional<Thirds> SplitByThirds(const std::vector<PairInRoom>& pairs) {
  if (pairs.empty()) return std::nullopt;
  std::vector<double> x;
  for (const PairInRoom& pair : pairs) x.push_back(pair.x);
  std::sort(x.begin(), x.end());
  Thirds thirds{.bounds = {NearestBound(x, 1.0 / 3), NearestBound(x, 2.0 / 3)}};
  std::array<std::vector<double>, 3> y;
  for (const PairInRoom& pair : pairs)
    y[pair.x <= thirds.bounds[0] ? 0 : pair.x <= thirds.bounds[1] ? 1 : 2].push_back(pair.y);
  for (size_t i = 0; i < y.size(); ++i) {
    if (y[i].empty()) continue;
    thirds.medians[i] = Median(y[i]);
    thirds.means[i] = ComputeStatistics(y[i])->mean;
  }
  return thirds;
}

}  // namespace armature
