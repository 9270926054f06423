// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/table_lookup.h"

#include <algorithm>

#include "base/text.h"

namespace armature {

std::string TableRow::Text(const std::string& column) const {
  const auto found = std::find(table_->columns.begin(), table_->columns.end(), column);
  if (found == table_->columns.end()) return "";
  return (*row_)[static_cast<size_t>(found - table_->columns.begin())].text;
}

std::optional<double> TableRow::Number(const std::string& column) const {
  const auto found = std::find(table_->columns.begin(), table_->columns.end(), column);
  if (found == table_->columns.end()) return std::nullopt;
  const Cell& cell = (*row_)[static_cast<size_t>(found - table_->columns.begin())];
  if (!cell.is_number) return std::nullopt;
  return ParseNumber(cell.text, table_->title);
}

std::vector<const Table*> TablesNamed(const std::vector<Table>& tables, const std::string& name) {
  std::vector<const Table*> named;
  for (const Table& table : tables) {
    if (table.name == name) named.push_back(&table);
  }
  return named;
}

std::optional<TableRow> FindRow(const Table& table, const std::function<bool(const TableRow&)>& is_it) {
  for (const std::vector<Cell>& row : table.rows) {
    const TableRow candidate(table, row);
    if (is_it(candidate)) return candidate;
  }
  return std::nullopt;
}

}  // namespace armature
