// SPDX-License-Identifier: BSD-3-Clause
#include "cli/compared_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/csv_fields.h"

namespace armature {
namespace {

ComparedValues PairByKey(const NamedValues& a, const NamedValues& b) {
  ComparedValues compared{a.name, a.digits, {}, 0, 0};
  for (const auto& [key, value] : a.values) {
    if (const auto found = b.values.find(key); found != b.values.end())
      compared.pairs.push_back({key, {key.series, value, found->second}});
  }
  compared.only_a = a.values.size() - compared.pairs.size();
  compared.only_b = b.values.size() - compared.pairs.size();
  return compared;
}

std::vector<Cell> DifferenceRow(const ComparedValues& compared) {
  const auto difference = ComputeDifference(compared);
  std::vector<Cell> row{TextCell(compared.name)};
  for (const auto value : {&PairedDifference::median_a, &PairedDifference::median_b,
                           &PairedDifference::mean_a, &PairedDifference::mean_b, &PairedDifference::median,
                           &PairedDifference::low, &PairedDifference::high}) {
    row.push_back(difference ? NumberCell((*difference).*value, compared.digits) : NoCell());
  }
  row.push_back(difference ? TextCell(MarkName(difference->mark)) : NoCell());
  row.push_back(CountCell(static_cast<long>(compared.pairs.size())));
  row.push_back(CountCell(static_cast<long>(compared.only_a)));
  row.push_back(CountCell(static_cast<long>(compared.only_b)));
  return row;
}

}  // namespace

std::vector<ComparedValues> PairValues(const std::vector<NamedValues>& a, const std::vector<NamedValues>& b) {
  std::vector<ComparedValues> compared;
  for (const NamedValues& of_a : a) {
    const auto of_b =
        std::find_if(b.begin(), b.end(), [&](const NamedValues& other) { return other.name == of_a.name; });
    if (of_b != b.end()) compared.push_back(PairByKey(of_a, *of_b));
  }
  return compared;
}

std::optional<PairedDifference> ComputeDifference(const ComparedValues& compared) {
  std::vector<ValuePair> pairs;
  for (const auto& [key, pair] : compared.pairs) pairs.push_back(pair);
  return ComparePairs(pairs);
}

Table DifferenceTable(const std::vector<ComparedValues>& compared) {
  Table table;
  table.columns = {"quantity", "A median", "B median", "A mean", "B mean", "B - A",
                   "from",     "to",       "B is",     "pairs",  "only A", "only B"};
  for (const ComparedValues& values : compared) table.rows.push_back(DifferenceRow(values));
  table.notes = {
      "B - A: the median of the pairs' differences; from, to: between which it is in 95 of 100 cases (sign "
      "test; neighbouring frames that are alike count as fewer).",
      "B is: lower or higher where 0 is outside of that; same; too few: fewer than six independent pairs. Of "
      "twenty rows, one is marked by chance.",
      "Medians and means are of the pairs alone; only A, only B: values that the other does not have."};
  return table;
}

std::string RawPairColumns() { return "result,sequence,quantity,series,timestamp,index,a,b,difference\n"; }

std::string RawPairRows(const std::string& result, const std::string& sequence,
                        const std::vector<ComparedValues>& compared) {
  std::string rows;
  for (const ComparedValues& values : compared) {
    for (const auto& [key, pair] : values.pairs) {
      const std::string stamp =
          key.microseconds ? fmt::format("{:.6f}", static_cast<double>(*key.microseconds) / 1e6) : "";
      rows += fmt::format("{},{},{},{},{},{},{:.9g},{:.9g},{:.9g}\n", CsvField(result), CsvField(sequence),
                          CsvField(values.name), CsvField(key.series), stamp, key.index, pair.a, pair.b,
                          pair.b - pair.a);
    }
  }
  return rows;
}

}  // namespace armature
