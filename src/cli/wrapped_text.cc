// SPDX-License-Identifier: BSD-3-Clause
#include "cli/wrapped_text.h"

#include <sstream>

namespace armature {
namespace {

std::string WrappedLine(const std::string& line, size_t columns) {
  std::istringstream words(line);
  std::string text;
  size_t used = 0;
  for (std::string word; words >> word;) {
    if (used > 0 && used + 1 + word.size() > columns) {
      text += '\n';
      used = 0;
    }
    if (used > 0) text += ' ';
    used += word.size() + (used > 0 ? 1 : 0);
    text += word;
  }
  return text + '\n';
}

}  // namespace

std::string Wrapped(const std::string& text, size_t columns) {
  std::istringstream lines(text);
  std::string wrapped;
  for (std::string line; std::getline(lines, line);) wrapped += WrappedLine(line, columns);
  return wrapped;
}

std::string TwoColumns(const std::string& name, const std::string& meaning, const ColumnLayout& layout) {
  const std::string indent(layout.meaning, ' ');
  std::string text = std::string(layout.name, ' ') + name;
  const bool is_beside = text.size() + 2 <= layout.meaning;
  text += is_beside ? std::string(layout.meaning - text.size(), ' ') : "\n" + indent;
  std::istringstream lines(Wrapped(meaning, layout.end - layout.meaning));
  std::string line;
  for (bool is_first = true; std::getline(lines, line); is_first = false)
    text += (is_first ? "" : indent) + line + '\n';
  return text;
}

}  // namespace armature
