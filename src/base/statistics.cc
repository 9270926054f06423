// SPDX-License-Identifier: BSD-3-Clause
#include "base/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace armature {
namespace {

double InterpolateQuantile(const std::vector<double>& sorted, double fraction) {
  const double position = fraction * static_cast<double>(sorted.size() - 1);
  const size_t below = static_cast<size_t>(position);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

}  // namespace

double Median(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::optional<double> Quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  return InterpolateQuantile(values, fraction);
}

std::optional<SpanStatistics> ComputeStatistics(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  SpanStatistics s;
  s.n = values.size();
  const double n = static_cast<double>(s.n);
  for (const double value : values) s.mean += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  if (s.n > 1) s.deviation = std::sqrt(squares / (n - 1));
  s.median = InterpolateQuantile(values, 0.5);
  s.p10 = InterpolateQuantile(values, 0.1);
  s.p90 = InterpolateQuantile(values, 0.9);
  s.p99 = InterpolateQuantile(values, 0.99);
  s.max = values.back();
  const double reach = std::min(0.5, 1.5 / std::sqrt(n));
  s.median_low = InterpolateQuantile(values, 0.5 - reach);
  s.median_high = InterpolateQuantile(values, 0.5 + reach);
  return s;
}

}  // namespace armature
