// SPDX-License-Identifier: BSD-3-Clause
#include "base/csv_fields.h"

#include <algorithm>

#include "base/text.h"

namespace armature {
namespace {

// From the quote at `at`, which goes on behind the closing one.
std::string TakeQuoted(const std::string& line, size_t& at) {
  std::string field;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      field += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      field += line[at++];
    } else {
      ++at;
      break;
    }
  }
  return field;
}

}  // namespace

std::string CsvField(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

std::vector<std::string> SplitCsvFields(const std::string& line) {
  if (line.find('"') == std::string::npos) return SplitFields(line);
  std::vector<std::string> fields;
  for (size_t at = 0; at <= line.size(); ++at) {
    const size_t start = std::min(line.find_first_not_of(" \t", at), line.size());
    const bool is_quoted = start < line.size() && line[start] == '"';
    at = start;
    std::string field = is_quoted ? TakeQuoted(line, at) : "";
    const size_t end = std::min(line.find(',', at), line.size());
    const std::string rest = Trimmed(line.substr(at, end - at));
    fields.push_back(field + rest);
    at = end;
  }
  return fields;
}

}  // namespace armature
