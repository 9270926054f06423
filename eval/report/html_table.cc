// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/html_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "eval/report/html_text.h"

namespace armature {
namespace {

constexpr size_t kUnfoldedNotes = 220;  // characters of all notes together

// Whether a column's head stands over numbers.
bool HoldsNumbers(const Table& table, size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [column](const std::vector<Cell>& row) { return row[column].is_number; });
}

std::string HeadHtml(const Table& table) {
  std::string html = "<thead><tr>";
  for (size_t i = 0; i < table.columns.size(); ++i) {
    html += fmt::format("<th scope=\"col\"{}>{}</th>", HoldsNumbers(table, i) ? " class=\"number\"" : "",
                        EscapedHtml(table.columns[i]));
  }
  return html + "</tr></thead>\n";
}

std::string CellHtml(const Cell& cell, bool among_numbers) {
  if (cell.text.empty()) return among_numbers ? "<td class=\"number\">–</td>" : "<td>–</td>";
  return fmt::format("<td{}>{}</td>", cell.is_number ? " class=\"number\"" : "", EscapedHtml(cell.text));
}

std::string BodyHtml(const Table& table) {
  std::string html = "<tbody>\n";
  for (const std::vector<Cell>& row : table.rows) {
    html += "<tr>";
    for (size_t i = 0; i < row.size(); ++i) html += CellHtml(row[i], HoldsNumbers(table, i));
    html += "</tr>\n";
  }
  return html + "</tbody>";
}

std::string NotesHtml(const std::vector<std::string>& notes) {
  if (notes.empty()) return "";
  std::string list = "<ul class=\"notes\">";
  size_t length = 0;
  for (const std::string& note : notes) {
    list += fmt::format("<li>{}</li>", EscapedHtml(note));
    length += note.size();
  }
  list += "</ul>\n";
  if (length <= kUnfoldedNotes) return list;
  return fmt::format("<details class=\"notes\"><summary>What the columns mean</summary>{}</details>\n", list);
}

}  // namespace

std::string TableHtml(const Table& table, const std::string& id) {
  return fmt::format(
      "<figure class=\"table\" id=\"{}\">\n<figcaption>{}</figcaption>\n<div class=\"scroll\" "
      "role=\"region\" aria-label=\"{}\" tabindex=\"0\">"
      "<table>\n{}{}</table></div>\n{}</figure>\n",
      EscapedHtml(id), EscapedHtml(table.title), EscapedHtml(table.title), HeadHtml(table), BodyHtml(table),
      NotesHtml(table.notes));
}

}  // namespace armature
