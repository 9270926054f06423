// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/table_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/text.h"
#include "io/json_file.h"

namespace armature {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void Reject(const std::string& where, const std::string& what) {
  throw InputError(
      fmt::format("{}: is not a table as commands print it with --json: {}; make it again", where, what));
}

std::string TextMember(const Json& json, const char* name, const std::string& where) {
  const auto found = json.find(name);
  if (found == json.end()) return "";
  if (!found->is_string()) Reject(where, fmt::format("'{}' is no text", name));
  return found->get<std::string>();
}

std::vector<std::string> TextsMember(const Json& json, const char* name, const std::string& where) {
  const auto found = json.find(name);
  const auto is_text = [](const Json& entry) { return entry.is_string(); };
  if (found == json.end() || !found->is_array() || !std::all_of(found->begin(), found->end(), is_text))
    Reject(where, fmt::format("'{}' is no list of texts", name));
  return found->get<std::vector<std::string>>();
}

Cell MakeCell(const Json& row, const std::string& column, const std::string& where) {
  const auto found = row.find(column);
  if (found == row.end()) Reject(where, fmt::format("a row has no {}", Quoted(column)));
  if (found->is_null()) return NoCell();
  if (found->is_string()) return TextCell(found->get<std::string>());
  if (!found->is_number()) Reject(where, fmt::format("{} is neither text nor number", Quoted(column)));
  return {found->dump(), true};
}

// Digits after the point; 0 of whole numbers and of those with an exponent.
size_t CountDigits(const Cell& cell) {
  const size_t point = cell.text.find('.');
  if (!cell.is_number || point == std::string::npos || cell.text.find('e') != std::string::npos) return 0;
  return cell.text.size() - point - 1;
}

void RestoreZeros(Table& table) {
  for (size_t column = 0; column < table.columns.size(); ++column) {
    size_t digits = 0;
    for (const auto& row : table.rows) digits = std::max(digits, CountDigits(row[column]));
    for (auto& row : table.rows) {
      const size_t has = CountDigits(row[column]);
      if (has > 0) row[column].text.append(digits - has, '0');
    }
  }
}

Table TableFromJson(const Json& json, const std::string& where) {
  if (!json.is_object()) Reject(where, "it is no object");
  Table table;
  table.title = TextMember(json, "title", where);
  table.name = TextMember(json, "table", where);
  table.sequence = TextMember(json, "sequence", where);
  table.columns = TextsMember(json, "columns", where);
  table.notes = TextsMember(json, "notes", where);
  const auto rows = json.find("rows");
  if (rows == json.end() || !rows->is_array()) Reject(where, "it has no rows");
  for (const Json& row : *rows) {
    if (!row.is_object()) Reject(where, "a row is no object");
    std::vector<Cell>& cells = table.rows.emplace_back();
    for (const std::string& column : table.columns) cells.push_back(MakeCell(row, column, where));
  }
  if (table.name != "paper") RestoreZeros(table);  // the paper's own numbers have digits as printed
  return table;
}

}  // namespace

std::vector<Table> TablesFromJson(const Json& json, const std::string& where) {
  if (!json.is_array()) return {TableFromJson(json, where)};
  std::vector<Table> tables;
  for (const Json& table : json) tables.push_back(TableFromJson(table, where));
  return tables;
}

std::vector<Table> ReadTables(const std::filesystem::path& file) {
  const Json json = ReadJson(file, "give what a command printed with --json");
  const bool is_kept = json.is_object() && json.contains("tables");
  return TablesFromJson(is_kept ? json["tables"] : json, file.string());
}

}  // namespace armature
