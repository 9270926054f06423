// SPDX-License-Identifier: BSD-3-Clause
#include "base/text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/errors.h"

namespace armature {
namespace {

constexpr size_t kShownCharacters = 80;

std::string WithoutComment(const std::string& line) {
  for (size_t at = line.find('#'); at != std::string::npos; at = line.find('#', at + 1)) {
    if (at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t') return line.substr(0, at);
  }
  return line;
}

}  // namespace

std::string ReadTextFile(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(fmt::format("{}: is a folder; name a file", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(
        fmt::format("{}: cannot be opened; check that it exists and may be read", file.string()));
  }
  std::ostringstream content;
  content << stream.rdbuf();
  return std::move(content).str();
}

std::vector<TextLine> ReadTextLines(const std::filesystem::path& file) {
  std::string content = ReadTextFile(file);
  if (content.starts_with("\xEF\xBB\xBF")) content.erase(0, 3);  // byte order mark
  std::istringstream stream(content);
  std::vector<TextLine> lines;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::string text = Trimmed(WithoutComment(line));
    if (!text.empty()) lines.push_back({number, std::move(text)});
  }
  return lines;
}

std::string Trimmed(const std::string& text) {
  const char* blanks = " \t\r";
  const size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string Quoted(const std::string& text) {
  std::string shown = "'";
  for (const char c : text.substr(0, kShownCharacters)) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    shown += is_control ? '?' : c;
  }
  if (text.size() > kShownCharacters) shown += "...";
  return shown + "'";
}

double ParseNumber(const std::string& text, const std::string& where) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    throw InputError(fmt::format("{}: {} is not a finite number; write one like 0.5", where, Quoted(text)));
  }
  return value;
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

std::vector<double> ParseNumbers(const std::string& text, const std::string& where) {
  std::vector<double> numbers;
  for (size_t start = 0; !text.empty() && start <= text.size();) {
    const size_t end = std::min(text.find(';', start), text.size());
    numbers.push_back(ParseNumber(text.substr(start, end - start), where));
    start = end + 1;
  }
  return numbers;
}

int ParseInteger(const std::string& text, const std::string& where) {
  const double value = ParseNumber(text, where);
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
    throw InputError(fmt::format("{}: {} is not a whole number; write one like 3", where, Quoted(text)));
  }
  return static_cast<int>(value);
}

}  // namespace armature
