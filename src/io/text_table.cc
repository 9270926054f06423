// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/csv_fields.h"
#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/number_format.h"
#include "base/printable.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

bool IsNothing(const Cell& cell) { return cell.text.empty(); }

std::string Shown(const Cell& cell) { return IsNothing(cell) ? "-" : cell.text; }

// Characters as they are seen: bytes that continue a UTF-8 sequence take no room.
size_t Width(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string Padded(const std::string& text, size_t width, bool right) {
  const std::string blanks(width - std::min(width, Width(text)), ' ');
  return right ? blanks + text : text + blanks;
}

bool IsNumeric(const Table& table, size_t column) {
  bool numeric = false;
  for (const auto& row : table.rows) {
    if (!row[column].is_number && !IsNothing(row[column])) return false;
    numeric = numeric || row[column].is_number;
  }
  return numeric;
}

// How a format writes a table's rows; `escape` is applied to every text.
struct Layout {
  std::string left, between, right;  // of a row
  std::string (*escape)(const std::string&);
};

std::string Unchanged(const std::string& text) { return text; }

std::string EscapedMarkdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string EscapedLatex(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      escaped += fmt::format("\\{}{{}}", c);
    } else {
      if (std::string("&%$#_{}").find(c) != std::string::npos) escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

const Layout kText{"", "  ", "", Unchanged};
const Layout kMarkdown{"| ", " | ", " |", EscapedMarkdown};
const Layout kLatex{"", " & ", " \\\\", EscapedLatex};

using TextRow = std::vector<std::string>;

// The header and the rows, escaped.
std::vector<TextRow> TextRows(const Table& table, const Layout& layout) {
  std::vector<TextRow> rows(1);
  for (const std::string& column : table.columns) rows[0].push_back(layout.escape(column));
  for (const auto& row : table.rows) {
    rows.emplace_back();
    for (const Cell& cell : row) rows.back().push_back(layout.escape(Shown(cell)));
  }
  return rows;
}

std::vector<size_t> Widths(const std::vector<TextRow>& rows) {
  std::vector<size_t> widths(rows[0].size(), 3);
  for (const TextRow& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  return widths;
}

// One string a line, without line breaks and without blanks at the end.
std::vector<std::string> AlignedLines(const Table& table, const Layout& layout) {
  const std::vector<TextRow> rows = TextRows(table, layout);
  const std::vector<size_t> widths = Widths(rows);
  std::vector<std::string> lines;
  for (const TextRow& row : rows) {
    TextRow cells;
    for (size_t i = 0; i < row.size(); ++i) cells.push_back(Padded(row[i], widths[i], IsNumeric(table, i)));
    std::string line = layout.left + fmt::format("{}", fmt::join(cells, layout.between)) + layout.right;
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

// In lines of at most so many characters, later ones indented; a longer word has a line of its own.
std::string Wrapped(const std::string& note) {
  constexpr size_t kWidth = 110;
  std::string text, line;
  std::istringstream words(note);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kWidth) {
      text += line + "\n";
      line = "  " + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
  }
  return text + line + "\n";
}

std::string FormatText(const Table& table) {
  std::string text = table.title.empty() ? "" : table.title + "\n";
  std::vector<std::string> lines = AlignedLines(table, kText);
  size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, Width(line));
  lines.insert(lines.begin() + 1, std::string(widest, '-'));
  text += fmt::format("{}\n", fmt::join(lines, "\n"));
  for (const std::string& note : table.notes) text += Wrapped(note);
  return text;
}

std::string FormatMarkdown(const Table& table) {
  std::string text = table.title.empty() ? "" : fmt::format("**{}**\n\n", table.title);
  std::vector<std::string> lines = AlignedLines(table, kMarkdown);
  TextRow rule;
  for (size_t i = 0; i < table.columns.size(); ++i) rule.push_back(IsNumeric(table, i) ? "--:" : ":--");
  lines.insert(lines.begin() + 1, fmt::format("| {} |", fmt::join(rule, " | ")));
  text += fmt::format("{}\n", fmt::join(lines, "\n"));
  for (const std::string& note : table.notes) text += fmt::format("\n{}\n", note);
  return text;
}

std::string FormatLatex(const Table& table) {
  std::string alignment;
  for (size_t i = 0; i < table.columns.size(); ++i) alignment += IsNumeric(table, i) ? 'r' : 'l';
  std::vector<std::string> lines = AlignedLines(table, kLatex);
  lines.insert(lines.begin() + 1, "\\midrule");
  std::string text = table.title.empty() ? "" : fmt::format("% {}\n", table.title);
  text += fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n{}\n\\bottomrule\n\\end{{tabular}}\n", alignment,
                      fmt::join(lines, "\n"));
  for (const std::string& note : table.notes) text += fmt::format("% {}\n", note);
  return text;
}

// Nothing is an empty field; title and notes are comments.
std::string FormatCsv(const Table& table) {
  std::string text = table.title.empty() ? "" : fmt::format("# {}\n", table.title);
  TextRow fields;
  for (const std::string& column : table.columns) fields.push_back(CsvField(column));
  text += fmt::format("{}\n", fmt::join(fields, ","));
  for (const auto& row : table.rows) {
    fields.clear();
    for (const Cell& cell : row) fields.push_back(CsvField(cell.text));
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  for (const std::string& note : table.notes) text += fmt::format("# {}\n", note);
  return text;
}

Json CellJson(const Cell& cell) {
  if (IsNothing(cell)) return nullptr;
  return cell.is_number ? Json::parse(cell.text) : Json(cell.text);
}

std::string FormatJson(const Table& table) {
  Json json = Json::object();
  if (!table.name.empty()) json["table"] = table.name;
  if (!table.sequence.empty()) json["sequence"] = table.sequence;
  json.update(
      {{"title", table.title}, {"columns", table.columns}, {"rows", Json::array()}, {"notes", table.notes}});
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (size_t i = 0; i < row.size(); ++i) object[table.columns[i]] = CellJson(row[i]);
    json["rows"].push_back(object);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Names of others may stand in any text of it.
Table PrintableTable(Table table) {
  table.title = Printable(table.title);
  for (std::string& column : table.columns) column = Printable(column);
  for (std::string& note : table.notes) note = Printable(note);
  for (auto& row : table.rows) {
    for (Cell& cell : row) cell.text = Printable(cell.text);
  }
  return table;
}

}  // namespace

Cell TextCell(std::string text) { return {std::move(text), false}; }

Cell NumberCell(std::optional<double> value, int digits) {
  const std::string text = value ? Fixed(*value, digits) : "";
  return {text, !text.empty()};
}

Cell CountCell(long count) { return {fmt::format("{}", count), true}; }

Cell PercentCell(double part, double whole) {
  return whole > 0 ? NumberCell(100 * part / whole, 1) : NoCell();
}

Cell ShareCell(std::optional<double> share, long whole) {
  const double n = static_cast<double>(whole);
  return share ? PercentCell(std::round(*share * n), n) : NoCell();
}

Cell NoCell() { return {}; }

const std::vector<std::string>& TableFormatNames() {
  static const std::vector<std::string> kNames{"text", "markdown", "csv", "latex", "json"};
  return kNames;
}

TableFormat TableFormatFromName(const std::string& name) {
  const std::vector<std::string>& names = TableFormatNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw InputError(UnknownNameMessage("table format", name, names));
  return static_cast<TableFormat>(found - names.begin());
}

std::string FormatTable(const Table& given, TableFormat format) {
  for (const auto& row : given.rows) {
    if (row.size() != given.columns.size())
      throw std::logic_error("a row of '" + given.title + "' is incomplete");
  }
  if (format == TableFormat::kJson) return FormatJson(given);  // escapes by itself
  const Table table = PrintableTable(given);
  switch (format) {
    case TableFormat::kText:
      return FormatText(table);
    case TableFormat::kMarkdown:
      return FormatMarkdown(table);
    case TableFormat::kCsv:
      return FormatCsv(table);
    case TableFormat::kLatex:
      return FormatLatex(table);
    case TableFormat::kJson:
      break;
  }
  throw std::logic_error("unknown table format");
}

}  // namespace armature
