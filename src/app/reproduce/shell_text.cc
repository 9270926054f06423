// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/shell_text.h"

#include <string_view>

namespace armature {
namespace {

constexpr std::string_view kPlain =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,=+@%";

std::string ShellWord(const std::string& text) {
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string ShellText(const std::vector<std::string>& arguments) {
  std::string text = "armature";
  for (const std::string& argument : arguments) text += " " + ShellWord(argument);
  return text;
}

}  // namespace armature
