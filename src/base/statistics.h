// SPDX-License-Identifier: BSD-3-Clause
// Medians, quantiles, and what a table says about many values.
#pragma once

#include <optional>
#include <vector>

namespace armature {

// The middle value, the mean of the two middle ones of an even number; values must not be empty.
double Median(std::vector<double> values);

// The value below which the fraction (0..1) of the values lies, linear between neighbours (numpy's default).
// None of no value.
std::optional<double> Quantile(std::vector<double> values, double fraction);

struct SpanStatistics {
  size_t n = 0;
  double mean = 0, deviation = 0;  // sample standard deviation, 0 for a single value
  double median = 0, p10 = 0, p90 = 0, p99 = 0, max = 0;

  // Between which the median of many more values lies, three standard deviations sure, however they are
  // distributed: as n/2 +- 3 sqrt(n)/2 of n values are below it (a binomial distribution), the values of
  // those ranks; the least and the greatest of fewer than nine.
  double median_low = 0, median_high = 0;

  double spread() const { return 0.5 * (p90 - p10) / median; }  // of single values, relative
};

// None of nothing: a stage that never ran. Quantiles are linear between neighbours.
std::optional<SpanStatistics> ComputeStatistics(std::vector<double> values);

}  // namespace armature
