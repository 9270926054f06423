// SPDX-License-Identifier: BSD-3-Clause
#include "bench/spans.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace armature {
namespace {

double SumStages(const FrameOutcome& outcome) {
  double sum = 0;
  for (const std::optional<double>& stage : outcome.stages_ms) sum += stage.value_or(0);
  return sum;
}

std::optional<double> Processing(const FrameOutcome& outcome) {
  const auto& association = outcome.stage(BenchStage::kAssociation);
  const auto& optimization = outcome.stage(BenchStage::kOptimization);
  if (!association && !optimization) return std::nullopt;
  return association.value_or(0) + optimization.value_or(0);
}

}  // namespace

std::optional<double> FindDuration(const BenchRow& row, std::string_view span) {
  if (span == kTotal) return row.total_ms();
  if (span == kProcessing) return Processing(row.outcome);
  if (span == kOnTop) return row.total_ms() - row.outcome.stage(BenchStage::kDetection).value_or(0);
  if (span == kOther) return row.total_ms() - SumStages(row.outcome);
  const auto found = std::find(kBenchStageNames.begin(), kBenchStageNames.end(), span);
  if (found == kBenchStageNames.end()) throw std::logic_error("no such span: " + std::string(span));
  return row.outcome.stages_ms[static_cast<size_t>(found - kBenchStageNames.begin())];
}

std::vector<double> CollectDurations(const std::vector<BenchRow>& rows, const std::string& contender,
                                     std::string_view span) {
  std::vector<double> durations;
  for (const BenchRow& row : rows) {
    if (row.contender != contender) continue;
    if (const auto duration = FindDuration(row, span)) durations.push_back(*duration);
  }
  return durations;
}

std::optional<double> ComputeMedian(const std::vector<double>& values) {
  const auto statistics = ComputeStatistics(values);
  return statistics ? std::optional(statistics->median) : std::nullopt;
}

std::optional<double> MedianDuration(const std::vector<BenchRow>& rows, const std::string& contender,
                                     std::string_view span) {
  return ComputeMedian(CollectDurations(rows, contender, span));
}

std::vector<double> DurationsAnObject(const std::vector<BenchRow>& rows, const std::string& contender,
                                      std::string_view span) {
  std::vector<double> durations;
  for (const BenchRow& row : rows) {
    if (row.contender != contender || row.outcome.objects == 0) continue;
    if (const auto duration = FindDuration(row, span)) durations.push_back(*duration / row.outcome.objects);
  }
  return durations;
}

std::vector<NamedSpan> CollectSpans(const std::string& table, const std::string& sequence,
                                    const std::vector<BenchRow>& rows,
                                    const std::vector<std::string>& contenders) {
  std::vector<std::string_view> names(kBenchStageNames.begin(), kBenchStageNames.end());
  names.push_back(kTotal);
  std::vector<NamedSpan> spans;
  for (const std::string& contender : contenders) {
    for (const std::string_view name : names) {
      const auto statistics = ComputeStatistics(CollectDurations(rows, contender, name));
      if (statistics) spans.push_back({table, sequence, contender, std::string(name), *statistics});
    }
  }
  return spans;
}

std::vector<NamedRatio> CollectRatios(const std::string& table, const std::string& sequence,
                                      const std::vector<BenchRow>& rows,
                                      const std::vector<std::string>& contenders) {
  std::vector<NamedRatio> ratios;
  const std::string& reference = contenders.front();
  for (const std::string& contender : contenders) {
    if (contender == reference) continue;
    const auto ratio = ComputeStatistics(PairedRatios(rows, contender, reference));
    if (ratio) ratios.push_back({table, sequence, contender, reference, *ratio});
  }
  return ratios;
}

std::vector<double> PairedRatios(const std::vector<BenchRow>& rows, const std::string& other,
                                 const std::string& reference) {
  std::map<std::pair<size_t, size_t>, double> reference_ms;  // by repetition and input
  for (const BenchRow& row : rows) {
    if (row.contender == reference) reference_ms[{row.repetition, row.input}] = row.total_ms();
  }
  std::vector<double> ratios;
  for (const BenchRow& row : rows) {
    if (row.contender != other) continue;
    const auto found = reference_ms.find({row.repetition, row.input});
    if (found != reference_ms.end()) ratios.push_back(row.total_ms() / found->second);
  }
  return ratios;
}

}  // namespace armature
