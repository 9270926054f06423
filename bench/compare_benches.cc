// SPDX-License-Identifier: BSD-3-Clause
#include "bench/compare_benches.h"

#include <algorithm>

#include "bench/guard/guarded_spans.h"
#include "bench/guard/paired_passes.h"
#include "bench/guard/regression_guard.h"
#include "io/provenance.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

BenchRecord GuardedRecord(const fs::path& folder) {
  BenchRecord record = ReadBenchRecord(folder / "bench.json");
  std::erase_if(record.spans, [](const NamedSpan& span) { return !IsMachinesWork(span); });
  return record;
}

}  // namespace

Comparison CompareBenches(const fs::path& a, const fs::path& b) {
  Comparison comparison;
  const GuardResult guard = CompareWithReference(GuardedRecord(a), GuardedRecord(b));
  comparison.tables.push_back(GuardTable(guard));
  comparison.tables.back().notes.emplace_back("The reference is A, now is B.");
  comparison.tables.back().name = "benchmark";
  const std::vector<ComparedValues> passes = PairPasses(a / "raw.csv", b / "raw.csv");
  comparison.tables.push_back(PassRatioTable(passes, guard.calibration_ratio()));
  comparison.tables.back().name = "passes";
  for (const ProvenanceRemark& remark : CompareBenchProvenance(a / "bench.json", b / "bench.json")) {
    if (remark.is_warning) comparison.warnings.push_back(remark.text);
    comparison.tables.back().notes.push_back(remark.text);
  }
  comparison.raw = RawPairRows(b.string(), "", passes);
  return comparison;
}

}  // namespace armature
