// SPDX-License-Identifier: BSD-3-Clause
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "base/input_file.h"
#include "base/printable.h"

namespace armature {
namespace {

constexpr size_t kShownCharacters = 80;
constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool IsBlank(char c) { return kBlanks.find(c) != std::string_view::npos; }

std::string_view TrimmedView(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string_view WithoutCommentView(std::string_view line, Comments comments) {
  for (size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    const bool is_own = line.find_first_not_of(kBlanks) == at;
    if (is_own || (comments == Comments::kAnywhere && IsBlank(line[at - 1]))) return line.substr(0, at);
  }
  return line;
}

// Takes the next line off the content.
std::string_view TakeLine(std::string_view& content) {
  const size_t end = std::min(content.find_first_of("\n\r"), content.size());
  const std::string_view line = content.substr(0, end);
  const size_t mark = content.substr(end).starts_with("\r\n") ? 2 : 1;
  content.remove_prefix(std::min(end + mark, content.size()));
  return line;
}

void CheckIsText(std::string_view content, const std::string& name) {
  const size_t zero = content.find('\0');
  if (zero == std::string_view::npos) return;
  const auto line = 1 + std::count(content.begin(), content.begin() + static_cast<long>(zero), '\n');
  throw InputError(
      fmt::format("{}:{}: holds a zero byte, so it is no text file; save it as text in UTF-8", name, line));
}

// As from_chars reads it: without '+', and with an 'e' for a 'd'.
std::string PlainNumber(std::string_view text) {
  std::string plain(text.starts_with('+') && !text.starts_with("+-") ? text.substr(1) : text);
  const size_t exponent = plain.find_first_of("dD");
  const bool is_fortran = exponent != std::string::npos && exponent > 0 && exponent + 1 < plain.size() &&
                          plain.find_first_not_of("0123456789.-+dD") == std::string::npos;
  if (is_fortran) plain[exponent] = 'e';
  return plain;
}

// Of a number beyond a double's range, in the form that from_chars takes: whether it is nearly 0, not huge.
bool IsTiny(std::string_view number) {
  const size_t mark = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, mark);
  double exponent = 0;
  if (mark < number.size()) {
    std::string_view power = number.substr(mark + 1);
    const bool is_negative = power.starts_with('-');
    if (is_negative || power.starts_with('+')) power.remove_prefix(1);
    for (const char c : power) exponent = 10 * exponent + (c - '0');
    if (is_negative) exponent = -exponent;
  }
  const size_t point = std::min(digits.find('.'), digits.size());
  const size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  return exponent + static_cast<double>(point) - static_cast<double>(first) < 0;
}

enum class NumberFault { kNone, kNoNumber, kTooLarge };

NumberFault ReadNumber(const std::string& text, double& value) {
  const std::string number = PlainNumber(text);
  const char* end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument) return NumberFault::kNoNumber;
  if (error == std::errc::result_out_of_range) {
    value = 0;
    return IsTiny(number) ? NumberFault::kNone : NumberFault::kTooLarge;
  }
  return std::isfinite(value) ? NumberFault::kNone : NumberFault::kNoNumber;
}

}  // namespace

std::string ReadTextFile(const std::filesystem::path& file) { return ReadInputFile(file); }

std::vector<TextLine> SplitLines(std::string_view content, const std::string& name, Comments comments) {
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  CheckIsText(content, name);
  std::vector<TextLine> lines;
  for (int number = 1; !content.empty(); ++number) {
    const std::string_view text = TrimmedView(WithoutCommentView(TakeLine(content), comments));
    if (!text.empty()) lines.push_back({number, std::string(text)});
  }
  return lines;
}

std::vector<TextLine> ReadTextLines(const std::filesystem::path& file, Comments comments) {
  return SplitLines(ReadTextFile(file), file.string(), comments);
}

std::string WithoutComment(const std::string& line) {
  return std::string(WithoutCommentView(line, Comments::kAnywhere));
}

std::string Trimmed(std::string_view text) { return std::string(TrimmedView(text)); }

std::vector<std::string> SplitWords(std::string_view line) {
  std::vector<std::string> words;
  for (size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.emplace_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::string Quoted(std::string_view text) {
  const std::string_view first = FirstBytes(text, kShownCharacters);
  return fmt::format("'{}{}'", Printable(first), first.size() < text.size() ? "..." : "");
}

double ParseNumber(const std::string& text, const std::string& where) {
  double value = 0;
  switch (ReadNumber(text, value)) {
    case NumberFault::kNone:
      return value;
    case NumberFault::kTooLarge:
      throw InputError(fmt::format("{}: {} is too large; write a number below 1.8e308", where, Quoted(text)));
    case NumberFault::kNoNumber:
      break;
  }
  throw InputError(fmt::format("{}: {} is not a finite number; write one like 0.5", where, Quoted(text)));
}

std::vector<std::string> SplitFields(const std::string& line) {
  std::vector<std::string> fields;
  size_t start = 0;
  for (size_t comma; (comma = line.find(',', start)) != std::string::npos; start = comma + 1) {
    fields.push_back(Trimmed(std::string_view(line).substr(start, comma - start)));
  }
  fields.push_back(Trimmed(std::string_view(line).substr(start)));
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
