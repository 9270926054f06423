// SPDX-License-Identifier: BSD-3-Clause
#include "bench/regression_guard.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "io/errors.h"

namespace armature {
namespace {

constexpr double kFloor = 0.05;
constexpr double kSigmas = 3;
constexpr size_t kFewest = 5;  // values; fewer say nothing about their spread

// Squared, relative to the median.
double MedianVariance(const SpanStatistics& s) {
  const double sigma = (s.p90 - s.p10) / 2.5631;
  const double error = 1.2533 * sigma / std::sqrt(static_cast<double>(s.n)) / s.median;
  return error * error;
}

Verdict VerdictOf(double ratio, double tolerance) {
  if (ratio > 1 + tolerance) return Verdict::kSlower;
  if (1 / ratio > 1 + tolerance) return Verdict::kFaster;
  return Verdict::kSame;
}

SpanComparison Compare(const NamedSpan& span, const SpanStatistics& reference, const GuardResult& result) {
  const SpanStatistics& now = span.milliseconds;
  SpanComparison comparison{.key = span.Key(), .reference = reference, .now = now};
  comparison.ratio = now.median / reference.median / result.calibration_ratio();
  comparison.tolerance = kFloor + kSigmas * std::sqrt(MedianVariance(reference) + MedianVariance(now)) +
                         result.calibration_spread();
  comparison.verdict = std::min(reference.n, now.n) < kFewest
                           ? Verdict::kTooFew
                           : VerdictOf(comparison.ratio, comparison.tolerance);
  return comparison;
}

std::map<std::string, SpanStatistics> ByKey(const std::vector<NamedSpan>& spans) {
  std::map<std::string, SpanStatistics> by_key;
  for (const NamedSpan& span : spans) by_key.emplace(span.Key(), span.milliseconds);
  return by_key;
}

}  // namespace

double GuardResult::calibration_spread() const {
  return std::max(calibration_reference.spread(), calibration_now.spread());
}

size_t GuardResult::Count(Verdict verdict) const {
  return static_cast<size_t>(std::count_if(
      spans.begin(), spans.end(), [verdict](const SpanComparison& span) { return span.verdict == verdict; }));
}

GuardResult CompareWithReference(const BenchRecord& reference, const BenchRecord& now) {
  GuardResult result;
  result.cpu_reference = reference.machine.cpu;
  result.cpu_now = now.machine.cpu;
  result.calibration_reference = reference.calibration;
  result.calibration_now = now.calibration;
  const std::map<std::string, SpanStatistics> before = ByKey(reference.spans), after = ByKey(now.spans);
  for (const NamedSpan& span : now.spans) {
    const auto found = before.find(span.Key());
    result.spans.push_back(found == before.end() ? SpanComparison{.key = span.Key(),
                                                                  .reference = {},
                                                                  .now = span.milliseconds,
                                                                  .verdict = Verdict::kNew}
                                                 : Compare(span, found->second, result));
  }
  if (result.Count(Verdict::kNew) == result.spans.size()) {
    throw InputError(
        "no span of the reference was measured now: measure the same tables and sequences, or "
        "write a new reference");
  }
  for (const NamedSpan& span : reference.spans) {
    if (!after.contains(span.Key()))
      result.spans.push_back(
          {.key = span.Key(), .reference = span.milliseconds, .now = {}, .verdict = Verdict::kMissing});
  }
  return result;
}

bool BecameSlower(const GuardResult& result) { return result.Count(Verdict::kSlower) > 0; }

}  // namespace armature
