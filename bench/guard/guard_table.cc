// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <set>

#include "bench/guard/regression_guard.h"

namespace armature {
namespace {

constexpr double kBusy = 0.15;  // spread of the calibration loop, which does the same every time

const char* VerdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::kSame:
      return "same";
    case Verdict::kSlower:
      return "slower";
    case Verdict::kFaster:
      return "faster";
    case Verdict::kTooFew:
      return "too few";
    case Verdict::kMissing:
      return "missing";
    case Verdict::kNew:
      return "new";
  }
  return "";
}

Cell MedianCell(const std::optional<SpanStatistics>& s) {
  return s ? NumberCell(s->median, s->median < 0.1 ? 5 : 3) : NoCell();
}

// Half of p10..p90.
Cell SpreadCell(const std::optional<SpanStatistics>& s) {
  return s ? NumberCell(100 * s->spread(), 1) : NoCell();
}

std::vector<Cell> ComparisonRow(const SpanComparison& span) {
  const bool both = span.reference && span.now;
  return {TextCell(span.key),
          MedianCell(span.reference),
          MedianCell(span.now),
          both ? NumberCell(span.ratio, 3) : NoCell(),
          SpreadCell(span.reference),
          SpreadCell(span.now),
          both ? NumberCell(100 * span.tolerance, 1) : NoCell(),
          TextCell(VerdictName(span.verdict))};
}

// Of those verdicts, in the order of the comparison.
void AddRows(const GuardResult& result, const std::set<Verdict>& verdicts, Table& table) {
  for (const SpanComparison& span : result.spans) {
    if (verdicts.contains(span.verdict)) table.rows.push_back(ComparisonRow(span));
  }
}

std::string Sums(const GuardResult& result) {
  std::string sums;
  for (const Verdict verdict : {Verdict::kSlower, Verdict::kFaster, Verdict::kSame, Verdict::kTooFew,
                                Verdict::kMissing, Verdict::kNew}) {
    sums += fmt::format("{}{} {}", sums.empty() ? "" : ", ", result.Count(verdict), VerdictName(verdict));
  }
  return sums;
}

std::vector<std::string> Notes(const GuardResult& result) {
  std::vector<std::string> notes;
  notes.emplace_back("Spans that moved come first: slower ones, then faster ones.");
  notes.push_back(
      fmt::format("ratio: median now over reference, divided by the same of the calibration loop in the same "
                  "table; that of all tables is {:.3f}.",
                  result.calibration_ratio()));
  notes.emplace_back("spread: half of p10..p90 over the median, of single values.");
  notes.emplace_back(
      "slower, faster: the ratio or its inverse is above 1 by more than the tolerance: 5 % and what the "
      "medians of both and of the calibration loops may be off by chance; too few: less than 5 values on a "
      "side.");
  notes.emplace_back(
      "Not compared: tables that were not measured now, and what is no work of this machine: the network of "
      "keypoints:published and keypoints:wait, and their totals.");
  return notes;
}

// What is said of times that are not to be trusted.
void AddWarnings(const GuardResult& result, Table& table) {
  if (result.calibration_spread() > kBusy) {
    table.notes.push_back(fmt::format(
        "A busy machine: the calibration loop's times spread by {:.0f} %; measure again when it has nothing "
        "else to do.",
        100 * result.calibration_spread()));
  }
  if (result.cpu_reference != result.cpu_now) {
    table.notes.push_back(fmt::format(
        "Another machine: the reference is of '{}', this is '{}'; ratios say little about the program.",
        result.cpu_reference, result.cpu_now));
  }
}

}  // namespace

Table GuardTable(const GuardResult& result) {
  Table table;
  table.title = "Against the reference: " + Sums(result);
  table.columns = {"span",           "reference [ms]", "now [ms]", "ratio", "spread then [%]",
                   "spread now [%]", "tolerance [%]",  "verdict"};
  AddRows(result, {Verdict::kSlower}, table);
  AddRows(result, {Verdict::kFaster}, table);
  AddRows(result, {Verdict::kSame, Verdict::kTooFew, Verdict::kMissing, Verdict::kNew}, table);
  table.notes = Notes(result);
  AddWarnings(result, table);
  return table;
}

}  // namespace armature
