// SPDX-License-Identifier: BSD-3-Clause
// What a table says.
#pragma once

#include <algorithm>
#include <string>

#include "io/text_table.h"

namespace armature::testing {

// A cell's text, empty where it is a dash.
inline std::string CellText(const Table& table, size_t row, const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) return "no such column";
  return table.rows.at(row).at(static_cast<size_t>(found - table.columns.begin())).text;
}

// All notes, a line each.
inline std::string NotesText(const Table& table) {
  std::string text;
  for (const std::string& note : table.notes) text += note + "\n";
  return text;
}

}  // namespace armature::testing
