// SPDX-License-Identifier: BSD-3-Clause
// One table, written as aligned text, Markdown, CSV, LaTeX or JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace armature {

// A text, a number, or nothing (shown as a dash).
struct Cell {
  std::string text;        // as shown; empty: nothing
  bool is_number = false;  // aligned to the right, and a number in JSON
};

Cell TextCell(std::string text);
// Fixed digits after the point; nothing for a value that is not finite or absent.
Cell NumberCell(std::optional<double> value, int digits);
Cell CountCell(long count);
Cell PercentCell(double part, double whole);  // one digit after the point; nothing for a part of nothing
// The same of a share of so many, 0..1: rounded as its count would be.
Cell ShareCell(std::optional<double> share, long whole);
Cell NoCell();  // nothing was measured

struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as the columns
  std::vector<std::string> notes;  // under the table: what each span or number means; wrapped in plain text
  // For programs: the kind of table, as commands take it ("objects"), and the sequence that it is of.
  std::string name{};
  std::string sequence{};  // empty: of none alone
};

enum class TableFormat { kText, kMarkdown, kCsv, kLatex, kJson };

// "text", "markdown", "csv", "latex", "json", in the order of the enumeration.
const std::vector<std::string>& TableFormatNames();

// Throws InputError for another name.
TableFormat TableFormatFromName(const std::string& name);

// Ends with a line break. Columns of numbers are aligned to the right. Throws std::logic_error when a row has
// another length than the columns.
std::string FormatTable(const Table& table, TableFormat format);

}  // namespace armature
