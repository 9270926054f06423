// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/line_fit.h"

#include "base/statistics.h"

namespace armature {
namespace {

std::vector<double> PairwiseSlopes(const std::vector<FitPoint>& points) {
  std::vector<double> slopes;
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const double run = points[i].x - points[j].x;
      if (run != 0) slopes.push_back((points[i].y - points[j].y) / run);
    }
  }
  return slopes;
}

}  // namespace

std::optional<LineFit> FitLine(const std::vector<FitPoint>& points) {
  const auto slopes = ComputeStatistics(PairwiseSlopes(points));
  if (!slopes) return std::nullopt;
  std::vector<double> remainders;
  for (const FitPoint& point : points) remainders.push_back(point.y - slopes->median * point.x);
  return LineFit{ComputeStatistics(remainders)->median, slopes->median};
}

std::optional<double> Crossing(const LineFit& a, const LineFit& b) {
  if (a.slope == b.slope) return std::nullopt;
  return (b.constant - a.constant) / (a.slope - b.slope);
}

}  // namespace armature
