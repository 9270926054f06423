// SPDX-License-Identifier: BSD-3-Clause
#include "io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "io/errors.h"

namespace armature {
namespace {

std::string Trimmed(const std::string& text) {
  const char* blanks = " \t\r";
  const size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> SplitFields(const std::string& line) {
  std::vector<std::string> fields;
  size_t start = 0;
  for (size_t comma; (comma = line.find(',', start)) != std::string::npos; start = comma + 1) {
    fields.push_back(Trimmed(line.substr(start, comma - start)));
  }
  fields.push_back(Trimmed(line.substr(start)));
  return fields;
}

}  // namespace

double ParseNumber(const std::string& text, const std::string& where) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    throw InputError(fmt::format("{}: '{}' is not a finite number", where, text));
  }
  return value;
}

const std::string& CsvRow::Text(const std::string& column) const { return fields_[table_->ColumnIndex(column)]; }

double CsvRow::Number(const std::string& column) const {
  return ParseNumber(Text(column), At(fmt::format("column '{}'", column)));
}

int CsvRow::Integer(const std::string& column) const {
  const double value = Number(column);
  if (value != std::floor(value) || std::abs(value) > 1e9) {
    throw InputError(At(fmt::format("column '{}': '{}' is not a whole number", column, Text(column))));
  }
  return static_cast<int>(value);
}

bool CsvRow::IsEmpty(const std::string& column) const { return Text(column).empty(); }

std::string CsvRow::At(const std::string& message) const {
  return fmt::format("{}:{}: {}", table_->file().string(), line_, message);
}

CsvTable::CsvTable(std::filesystem::path file, const std::vector<std::string>& required_columns)
    : file_(std::move(file)) {
  std::ifstream stream(file_);
  if (!stream) throw InputError(fmt::format("{}: cannot be opened; does it exist and may it be read?", file_.string()));
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    text = Trimmed(text);
    if (text.empty() || text[0] == '#') continue;
    std::vector<std::string> fields = SplitFields(text);
    if (header_.empty()) {
      header_ = std::move(fields);
      continue;
    }
    if (fields.size() != header_.size()) {
      throw InputError(fmt::format("{}:{}: {} fields where the header has {}", file_.string(), line, fields.size(),
                                   header_.size()));
    }
    rows_.emplace_back(this, line, std::move(fields));
  }
  if (header_.empty()) throw InputError(fmt::format("{}: has no header line", file_.string()));
  for (const std::string& column : required_columns) ColumnIndex(column);
}

bool CsvTable::HasColumn(const std::string& column) const {
  return std::find(header_.begin(), header_.end(), column) != header_.end();
}

size_t CsvTable::ColumnIndex(const std::string& column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) {
    throw InputError(fmt::format("{}: has no column '{}'; its header is '{}'", file_.string(), column,
                                 fmt::join(header_, ",")));
  }
  return static_cast<size_t>(found - header_.begin());
}

}  // namespace armature
