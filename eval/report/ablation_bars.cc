// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/ablation_bars.h"

#include <fmt/format.h>

#include <set>

#include "eval/report/table_lookup.h"

namespace armature {
namespace {

// The first row with each normal term.
std::vector<TableRow> PickFirstOfEachTerm(const Table& table) {
  std::vector<TableRow> rows;
  std::set<std::string> terms;
  for (const std::vector<Cell>& cells : table.rows) {
    const TableRow row(table, cells);
    const std::string term = row.Text("normal term");
    if (!term.empty() && terms.insert(term).second) rows.push_back(row);
  }
  return rows;
}

AblationBars MakeColumnBars(const Table& table, const std::vector<TableRow>& rows, const std::string& of,
                            const std::string& angle) {
  AblationBars bars{table.sequence, fmt::format("Mean absolute {} of {}", angle, of), "deg", {}};
  for (const TableRow& row : rows) {
    if (const auto value = row.Number(fmt::format("{}: {} mean", of, angle)))
      bars.bars.push_back({fmt::format("{}: {}", row.Text("normal term"), row.Text("run")), *value});
  }
  return bars;
}

}  // namespace

std::vector<AblationBars> NormalTermBars(const std::vector<Table>& tables) {
  std::vector<AblationBars> all;
  for (const Table* table : TablesNamed(tables, "normal")) {
    const std::vector<TableRow> rows = PickFirstOfEachTerm(*table);
    for (const char* of : {"observations", "objects"}) {
      for (const char* angle : {"pitch", "roll"}) {
        AblationBars bars = MakeColumnBars(*table, rows, of, angle);
        if (bars.bars.size() > 1) all.push_back(std::move(bars));
      }
    }
  }
  return all;
}

}  // namespace armature
