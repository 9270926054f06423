// SPDX-License-Identifier: BSD-3-Clause
#include "bench/guard/regression_guard.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/errors.h"
#include "bench/guard/calibration.h"

namespace armature {
namespace {

constexpr size_t kFewest = 5;  // values; fewer say nothing about their spread

double Squared(double value) { return value * value; }

// Squared errors, relative, of a median that may really be larger, and of one that may be smaller.
double UpwardError(const SpanStatistics& s) { return Squared(s.median_high / s.median - 1); }
double DownwardError(const SpanStatistics& s) { return Squared(1 - s.median_low / s.median); }

// By which `now` may be above `reference` by chance, both divided by their calibrations.
double Tolerance(const SpanStatistics& reference, const SpanStatistics& calibration_reference,
                 const SpanStatistics& now, const SpanStatistics& calibration_now) {
  return kGuardFloor + std::sqrt(UpwardError(reference) + DownwardError(calibration_reference) +
                                 DownwardError(now) + UpwardError(calibration_now));
}

Verdict JudgeSpan(const SpanComparison& span) {
  if (std::min(span.reference->n, span.now->n) < kFewest) return Verdict::kTooFew;
  if (std::max(span.ratio, 1 / span.ratio) <= 1 + span.tolerance) return Verdict::kSame;
  return span.ratio > 1 ? Verdict::kSlower : Verdict::kFaster;
}

bool IsCalibration(const NamedSpan& span) { return span.contender == kCalibrationName; }

// Of a span's table.
std::string CalibrationKey(const NamedSpan& span) {
  return NamedSpan{span.table, span.sequence, kCalibrationName, kCalibrationStage, {}}.Key();
}

using SpansByKey = std::map<std::string, SpanStatistics>;

// Reference and now: of the span's own table where both have it, for the machine drifts from one to the next.
std::pair<SpanStatistics, SpanStatistics> FindCalibrations(const NamedSpan& span, const SpansByKey& before,
                                                           const SpansByKey& after,
                                                           const GuardResult& result) {
  const auto reference = before.find(CalibrationKey(span)), now = after.find(CalibrationKey(span));
  if (reference == before.end() || now == after.end())
    return {result.calibration_reference, result.calibration_now};
  return {reference->second, now->second};
}

SpanComparison Compare(const NamedSpan& span, const SpanStatistics& reference,
                       const SpanStatistics& calibration_reference, const SpanStatistics& calibration_now) {
  const SpanStatistics& now = span.milliseconds;
  SpanComparison comparison{.key = span.Key(), .reference = reference, .now = now};
  comparison.ratio = now.median / reference.median / (calibration_now.median / calibration_reference.median);
  comparison.tolerance = comparison.ratio > 1
                             ? Tolerance(reference, calibration_reference, now, calibration_now)
                             : Tolerance(now, calibration_now, reference, calibration_reference);
  comparison.verdict = JudgeSpan(comparison);
  return comparison;
}

SpansByKey ByKey(const std::vector<NamedSpan>& spans) {
  SpansByKey by_key;
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
  result.cpu_reference = reference.cpu;
  result.cpu_now = now.cpu;
  result.calibration_reference = reference.calibration;
  result.calibration_now = now.calibration;
  const SpansByKey before = ByKey(reference.spans), after = ByKey(now.spans);
  for (const NamedSpan& span : now.spans) {
    if (IsCalibration(span)) continue;
    const auto found = before.find(span.Key());
    if (found == before.end()) {
      result.spans.push_back(
          {.key = span.Key(), .reference = {}, .now = span.milliseconds, .verdict = Verdict::kNew});
      continue;
    }
    const auto [calibration_before, calibration_after] = FindCalibrations(span, before, after, result);
    result.spans.push_back(Compare(span, found->second, calibration_before, calibration_after));
  }
  if (result.Count(Verdict::kNew) == result.spans.size()) {
    throw InputError(
        "no span of the reference was measured now: measure the same tables and sequences, or "
        "write a new reference");
  }
  for (const NamedSpan& span : reference.spans) {
    if (!IsCalibration(span) && !after.contains(span.Key()))
      result.spans.push_back(
          {.key = span.Key(), .reference = span.milliseconds, .now = {}, .verdict = Verdict::kMissing});
  }
  return result;
}

bool BecameSlower(const GuardResult& result) { return result.Count(Verdict::kSlower) > 0; }

}  // namespace armature
