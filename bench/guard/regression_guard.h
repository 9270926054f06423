// SPDX-License-Identifier: BSD-3-Clause
// What became slower or faster since a reference was kept.
//
// Medians are compared, each divided by the median of the calibration loop that took turns with it, in the
// same table and process:
//   ratio = (now / reference) / (calibration now / calibration of the reference).
// Where a side does not have a table's own, those of the whole processes are taken.
// How sure each of the four medians is comes from the order of its values (SpanStatistics::median_low,
// _high), which needs no bell curve: a busy machine makes some of the values several times as large. A span
// is slower when its ratio is above
//   1 + kGuardFloor + sqrt(sum of the four medians' errors squared),
// each error relative and towards the other side, and faster when the inverse of the ratio is. Errors are of
// three standard deviations, because a hundred spans are compared at once. The floor, because another process
// has other addresses and no calibration loop feels a machine exactly as every stage does. Seen with one
// program measured several times beside two or three other busy processes: mostly ratios within 9 % (pose
// graphs 16 %) and tolerances of 13 % (18 %); once medians doubled and more, and the tolerances with them;
// never a false alarm. The machine's drift within a run hits spans and calibration alike, for they take
// turns; a run of minutes drifts by more than the tolerance from table to table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/bench_record.h"
#include "io/text_table.h"

namespace armature {

inline constexpr double kGuardFloor = 0.05;

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
  double tolerance = 0;  // by which the ratio, or its inverse where that is larger, may be above 1
  Verdict verdict = Verdict::kSame;
};

struct GuardResult {
  std::vector<SpanComparison> spans;  // in the order of `now`, then the missing ones
  SpanStatistics calibration_reference, calibration_now;
  std::string cpu_reference, cpu_now;

  // Above 1: the machine is slower now.
  double calibration_ratio() const { return calibration_now.median / calibration_reference.median; }
  double calibration_spread() const;  // SpanStatistics::spread where it is larger
  size_t Count(Verdict verdict) const;
};

// Throws InputError when no span is on both sides: then nothing was guarded.
GuardResult CompareWithReference(const BenchRecord& reference, const BenchRecord& now);

// Whether the command has to fail. Spans that are missing or new do not matter to it.
bool BecameSlower(const GuardResult& result);

// One row a span, those that moved first; the sums and what the machine did below.
Table GuardTable(const GuardResult& result);

}  // namespace armature
