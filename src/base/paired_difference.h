// SPDX-License-Identifier: BSD-3-Clause
// How far pairs of values differ, and whether by more than chance.
//
// The difference is the median of b - a. Its interval is the sign test's: of n independent pairs, n/2 -+
// 1.96 sqrt(n)/2 have a difference below the true median (a binomial distribution), so the differences of
// those ranks enclose it in 95 of 100 cases, however they are distributed. Pairs that follow each other in a
// series (frames) are alike, and n of them say as much as
//   n (1 - r) / (1 + r)
// independent ones, with r the correlation of neighbours (a first-order process), here of their signs about
// the median, which is what the test counts.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace armature {

struct ValuePair {
  std::string series;  // neighbours of one series are alike; of different ones they are independent
  double a = 0, b = 0;
};

enum class DifferenceMark {
  kSame,    // 0 is in the interval
  kLower,   // b is lower than a by more than chance
  kHigher,  // b is higher
  kTooFew,  // independent pairs to say so: fewer than six
};
std::string MarkName(DifferenceMark mark);  // "same", "lower", "higher", "too few"

struct PairedDifference {
  size_t n = 0;            // pairs
  double independent = 0;  // so many independent ones say as much
  double median_a = 0, median_b = 0, mean_a = 0, mean_b = 0;
  double median = 0;         // of b - a
  double low = 0, high = 0;  // its interval; the least and the greatest where there are too few pairs
  DifferenceMark mark = DifferenceMark::kSame;
};

// In the order of their series. None of no pairs.
std::optional<PairedDifference> ComparePairs(const std::vector<ValuePair>& pairs);

// The same of b / a: `median`, `low` and `high` are ratios, to be compared with 1. Values have to be
// positive.
std::optional<PairedDifference> ComparePairRatios(const std::vector<ValuePair>& pairs);

}  // namespace armature
