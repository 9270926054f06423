// SPDX-License-Identifier: BSD-3-Clause
#include "bench/guard/guarded_spans.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "bench/guard/calibration.h"
#include "bench/spans.h"

namespace armature {

BenchRecord MakeRecord(const BenchEnvironment& environment, const BenchReport& report) {
  BenchRecord record{environment.machine.cpu, {}, {}};
  std::vector<double> passes;
  for (const BenchSection& section : report.sections) {
    passes.insert(passes.end(), section.calibration_ms.begin(), section.calibration_ms.end());
    record.spans.insert(record.spans.end(), section.spans.begin(), section.spans.end());
    if (const auto calibration = ComputeStatistics(section.calibration_ms))
      record.spans.push_back(
          {section.name, section.sequence, kCalibrationName, kCalibrationStage, *calibration});
  }
  std::erase_if(record.spans, [](const NamedSpan& span) { return !(span.milliseconds.median > 0); });
  record.calibration = ComputeStatistics(std::move(passes)).value_or(SpanStatistics{});
  return record;
}

bool IsMachinesWork(const NamedSpan& span) {
  const bool network = span.stage == kBenchStageNames[static_cast<size_t>(BenchStage::kDetection)];
  if (!network && span.stage != kTotal) return true;
  // Also "keypoints:wait with 3 objects".
  return !span.contender.starts_with("keypoints:published") && !span.contender.starts_with("keypoints:wait");
}

BenchRecord GuardedPart(BenchRecord record, const std::set<TableOfSequence>& measured) {
  std::erase_if(record.spans, [&](const NamedSpan& span) {
    return !IsMachinesWork(span) || !measured.contains({span.table, span.sequence});
  });
  return record;
}

void CheckSharesTables(const BenchRecord& reference, const std::set<TableOfSequence>& measured) {
  if (!GuardedPart(reference, measured).spans.empty()) return;
  std::set<std::string> there;
  for (const NamedSpan& span : reference.spans)
    there.insert(span.sequence.empty() ? span.table : fmt::format("{} of {}", span.table, span.sequence));
  throw InputError(fmt::format("--against: nothing of the reference would be measured; it has {}",
                               fmt::join(there, ", ")));
}

}  // namespace armature
