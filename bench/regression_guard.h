// SPDX-License-Identifier: BSD-3-Clause
// What became slower or faster since a reference was kept.
//
// Medians are compared, each divided by the median of its own process's calibration loop:
//   ratio = (now / reference) / (calibration now / calibration of the reference).
// A median of n values that scatter normally has the standard error 1.2533 sigma / sqrt(n); sigma comes from
// the values between p10 and p90, which outliers do not touch: (p90 - p10) / 2.5631. A span moved when its
// ratio or the inverse is above
//   1 + kFloor + kSigmas sqrt(sum of both relative standard errors squared) + calibration's spread.
// Three sigmas, because a hundred spans are compared at once. The spread is half of p10..p90 over the median,
// on the side where it is larger: when the machine's speed drifts within a run, the values are not
// independent and more of them do not help. The floor, because another process has other addresses and no
// calibration loop feels a machine exactly as every stage does. The frames of a sequence differ and are the
// same on both sides, so for them the standard error is rather too large.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/span_json.h"
#include "io/text_table.h"

namespace armature {

enum class Verdict {
  kSame,
  kSlower,
  kFaster,
  kTooFew,   // values, on one side, to say how sure its median is
  kMissing,  // not measured now
  kNew,      // not in the reference
};

struct SpanComparison {
  std::string key;  // NamedSpan::Key
  std::optional<SpanStatistics> reference, now;
  double ratio = 0;      // normalised; of those that are on both sides
  double tolerance = 0;  // by which the ratio or its inverse may be above 1
  Verdict verdict = Verdict::kSame;
};

struct GuardResult {
  std::vector<SpanComparison> spans;  // in the order of `now`, then the missing ones
  SpanStatistics calibration_reference, calibration_now;
  std::string cpu_reference, cpu_now;

  // Above 1: the machine is slower now.
  double calibration_ratio() const { return calibration_now.median / calibration_reference.median; }
  double calibration_spread() const;  // on the side where it is larger
  size_t Count(Verdict verdict) const;
};

// Throws InputError when no span is on both sides: then nothing was guarded.
GuardResult CompareWithReference(const BenchRecord& reference, const BenchRecord& now);

// Whether the command has to fail. Spans that are missing or new do not matter to it.
bool BecameSlower(const GuardResult& result);

// One row a span, the sums and what the machine did below.
Table GuardTable(const GuardResult& result);

}  // namespace armature
