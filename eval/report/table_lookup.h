// SPDX-License-Identifier: BSD-3-Clause
// Single numbers out of tables.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/text_table.h"

namespace armature {

// One row of a table, by the names of its columns.
class TableRow {
 public:
  // Keeps pointers to both.
  TableRow(const Table& table, const std::vector<Cell>& row) : table_(&table), row_(&row) {}

  // As shown; empty: nothing, or no such column.
  std::string Text(const std::string& column) const;
  // None: nothing, no number, or no such column.
  std::optional<double> Number(const std::string& column) const;

 private:
  const Table* table_;
  const std::vector<Cell>* row_;
};

// The tables of this name, in their order.
std::vector<const Table*> TablesNamed(const std::vector<Table>& tables, const std::string& name);

// The first row of which it is true.
std::optional<TableRow> FindRow(const Table& table, const std::function<bool(const TableRow&)>& is_it);

}  // namespace armature
