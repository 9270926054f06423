// SPDX-License-Identifier: BSD-3-Clause
#include "base/paired_difference.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace armature {
namespace {

constexpr double kFewest = 6;  // two signs alike in 1 of 32 cases only: less than 5 of 100
constexpr double kSigmas = 1.96;

double ComputeMean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

int GetSign(double value) { return (value > 0) - (value < 0); }

// Of neighbours' signs about the median, 0 where they are not alike.
double NeighbourCorrelation(const std::vector<ValuePair>& pairs, const std::vector<double>& differences,
                            double median) {
  int squares = 0, products = 0, neighbours = 0;
  for (size_t i = 1; i < pairs.size(); ++i) {
    if (pairs[i].series != pairs[i - 1].series) continue;
    const int before = GetSign(differences[i - 1] - median), here = GetSign(differences[i] - median);
    products += before * here;
    squares += std::abs(before * here);
    ++neighbours;
  }
  return squares == 0 || neighbours == 0 ? 0 : std::max(0.0, static_cast<double>(products) / squares);
}

// Between the values of the two nearest ranks; `rank` from 0.
double AtRank(const std::vector<double>& sorted, double rank) {
  const auto below = static_cast<size_t>(rank);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], rank - static_cast<double>(below));
}

void SetInterval(std::vector<double> differences, PairedDifference& result) {
  std::sort(differences.begin(), differences.end());
  result.low = differences.front();
  result.high = differences.back();
  const double m = result.independent;
  if (m < kFewest) {
    result.mark = DifferenceMark::kTooFew;
    return;
  }
  // The rank from 1 among m, as a share of the way from the first to the last value.
  const double share = (std::round((m - kSigmas * std::sqrt(m)) / 2) - 1) / (m - 1);
  const double last = static_cast<double>(differences.size() - 1);
  result.low = AtRank(differences, share * last);
  result.high = AtRank(differences, (1 - share) * last);
  if (result.low > 0) result.mark = DifferenceMark::kHigher;
  if (result.high < 0) result.mark = DifferenceMark::kLower;
}

// The interval of the median of `differences`, one a pair.
PairedDifference DifferenceBy(const std::vector<ValuePair>& pairs, const std::vector<double>& differences) {
  std::vector<double> a, b;
  for (const ValuePair& pair : pairs) {
    a.push_back(pair.a);
    b.push_back(pair.b);
  }
  PairedDifference result{.n = pairs.size(), .mean_a = ComputeMean(a), .mean_b = ComputeMean(b)};
  result.median_a = Median(a);
  result.median_b = Median(b);
  result.median = Median(differences);
  const double r = NeighbourCorrelation(pairs, differences, result.median);
  result.independent = static_cast<double>(result.n) * (1 - r) / (1 + r);
  SetInterval(differences, result);
  return result;
}

}  // namespace

std::string MarkName(DifferenceMark mark) {
  switch (mark) {
    case DifferenceMark::kSame:
      return "same";
    case DifferenceMark::kLower:
      return "lower";
    case DifferenceMark::kHigher:
      return "higher";
    case DifferenceMark::kTooFew:
      return "too few";
  }
  return "";
}

std::optional<PairedDifference> ComparePairs(const std::vector<ValuePair>& pairs) {
  if (pairs.empty()) return std::nullopt;
  std::vector<double> differences;
  for (const ValuePair& pair : pairs) differences.push_back(pair.b - pair.a);
  return DifferenceBy(pairs, differences);
}

std::optional<PairedDifference> ComparePairRatios(const std::vector<ValuePair>& pairs) {
  if (pairs.empty()) return std::nullopt;
  std::vector<double> logarithms;
  for (const ValuePair& pair : pairs) logarithms.push_back(std::log(pair.b / pair.a));
  PairedDifference result = DifferenceBy(pairs, logarithms);
  for (double* logarithm : {&result.median, &result.low, &result.high}) *logarithm = std::exp(*logarithm);
  return result;
}

}  // namespace armature
