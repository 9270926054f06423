// SPDX-License-Identifier: BSD-3-Clause
#include "bench/guard/paired_passes.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "bench/guard/guarded_spans.h"
#include "bench/guard/regression_guard.h"
#include "bench/spans.h"
#include "io/csv.h"
#include "truth/observation_metrics.h"

namespace armature {
namespace {

namespace fs = std::filesystem;
using SpanPasses = std::map<std::string, NamedValues>;  // by NamedSpan::Key

std::vector<std::string> StageColumns() {
  std::vector<std::string> columns(kBenchStageNames.begin(), kBenchStageNames.end());
  columns.emplace_back(kTotal);
  return columns;
}

void AddPasses(const CsvRow& row, const std::vector<std::string>& stages, SpanPasses& passes) {
  for (const std::string& stage : stages) {
    const NamedSpan span{row.Text("table"), row.Text("sequence"), row.Text("contender"), stage, {}};
    if (row.IsEmpty(stage) || !IsMachinesWork(span)) continue;
    NamedValues& values = passes[span.Key()];
    values.name = span.Key();
    const ValueKey key{"repetition " + row.Text("repetition"), {}, row.Integer("frame")};
    if (!values.values.emplace(key, row.Number(stage)).second)
      throw InputError(row.At("the pass of this repetition and frame is there twice; measure again"));
  }
}

std::vector<NamedValues> ReadPasses(const fs::path& raw) {
  const std::vector<std::string> stages = StageColumns();
  std::vector<std::string> columns{"table", "sequence", "contender", "repetition", "frame"};
  columns.insert(columns.end(), stages.begin(), stages.end());
  const CsvTable table(raw, columns);
  SpanPasses passes;
  for (const CsvRow& row : table.rows()) AddPasses(row, stages, passes);
  std::vector<NamedValues> spans;
  for (const auto& [key, values] : passes) spans.push_back(values);
  return spans;
}

// A pass in which a stage had nothing to do has no ratio.
std::vector<ValuePair> WithWork(const ComparedValues& span) {
  std::vector<ValuePair> pairs;
  for (const auto& [key, pair] : span.pairs) {
    if (pair.a > 0 && pair.b > 0) pairs.push_back(pair);
  }
  return pairs;
}

// The mark is of what is beyond the guard's floor.
PairedDifference Calibrated(PairedDifference ratio, double calibration_ratio) {
  for (double* value : {&ratio.median, &ratio.low, &ratio.high}) *value /= calibration_ratio;
  if (ratio.mark == DifferenceMark::kTooFew) return ratio;
  ratio.mark = DifferenceMark::kSame;
  if (ratio.low > 1 + kGuardFloor) ratio.mark = DifferenceMark::kHigher;
  if (ratio.high < 1 / (1 + kGuardFloor)) ratio.mark = DifferenceMark::kLower;
  return ratio;
}

std::vector<Cell> RatioRow(const ComparedValues& span, const PairedDifference& ratio) {
  return {TextCell(span.name),
          NumberCell(ratio.median_a, ratio.median_a < 0.1 ? 5 : 3),
          NumberCell(ratio.median_b, ratio.median_b < 0.1 ? 5 : 3),
          NumberCell(ratio.median, 3),
          NumberCell(ratio.low, 3),
          NumberCell(ratio.high, 3),
          TextCell(MarkName(ratio.mark)),
          CountCell(static_cast<long>(ratio.n)),
          CountCell(static_cast<long>(span.only_a)),
          CountCell(static_cast<long>(span.only_b))};
}

}  // namespace

std::vector<ComparedValues> PairPasses(const fs::path& raw_a, const fs::path& raw_b) {
  std::vector<ComparedValues> spans = PairValues(ReadPasses(raw_a), ReadPasses(raw_b));
  std::erase_if(spans,
                [](const ComparedValues& span) { return 2 * WithWork(span).size() <= span.pairs.size(); });
  return spans;
}

Table PassRatioTable(const std::vector<ComparedValues>& passes, double calibration_ratio) {
  Table table;
  table.title = "Pass by pass: B / A of the same frame and repetition";
  table.columns = {"span", "A [ms]", "B [ms]", "B / A", "from", "to", "B is", "pairs", "only A", "only B"};
  for (const ComparedValues& span : passes) {
    if (const auto ratio = ComparePairRatios(WithWork(span)))
      table.rows.push_back(RatioRow(span, Calibrated(*ratio, calibration_ratio)));
  }
  table.notes = {
      "B / A: the median of the passes' ratios, over the ratio of the calibration loops of all tables; from, "
      "to: between which it is in 95 of 100 cases (sign test).",
      "B is: lower or higher where all of that is more than 5 % away from 1; too few: fewer than six "
      "independent passes."};
  return table;
}

}  // namespace armature
