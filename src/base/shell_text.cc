// SPDX-License-Identifier: BSD-3-Clause
#include "base/shell_text.h"

#include <string_view>

namespace armature {
namespace {

constexpr std::string_view kPlain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+@%";

std::string ShellWord(const std::string& text) {
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted(1, '\'');
  for (const char c : text) {
    if (c == '\'') quoted += "'\\'";  // out of the quotes, the quote itself, in again
    quoted += c;
  }
  quoted += '\'';
  return quoted;
}

}  // namespace

std::string ShellText(const std::vector<std::string>& arguments) {
  std::string text = "armature";
  for (const std::string& argument : arguments) {
    text += ' ';
    text += ShellWord(argument);
  }
  return text;
}

}  // namespace armature
