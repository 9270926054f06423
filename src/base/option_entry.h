// SPDX-License-Identifier: BSD-3-Clause
// Options as data: one row an option, from which configuration files, --set and --help are read and written.
#pragma once

#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace armature {

struct OptionEntry {
  std::string key;   // "association.detector": maps of the configuration file, joined by dots
  std::string help;  // one sentence, with the unit
  std::variant<double*, int*, bool*, std::string*> field;
  double min = -std::numeric_limits<double>::infinity();  // numbers only, inclusive
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  // texts only; empty: any text
};

// Rows of the table, a line each: Option("lines.min_length", &o.lines.min_length, "shortest segment, pixels",
// 0, 1000).
template <typename Number>
requires(std::is_same_v<Number, double> || std::is_same_v<Number, int>) OptionEntry
    Option(std::string key, Number* field, std::string help,
           double min = -std::numeric_limits<double>::infinity(),
           double max = std::numeric_limits<double>::infinity()) {
  return {std::move(key), std::move(help), field, min, max, {}};
}

inline OptionEntry Option(std::string key, bool* field, std::string help) {
  return {.key = std::move(key), .help = std::move(help), .field = field, .choices = {}};
}

inline OptionEntry Option(std::string key, std::string* field, std::string help,
                          std::vector<std::string> choices = {}) {
  return {.key = std::move(key), .help = std::move(help), .field = field, .choices = std::move(choices)};
}

}  // namespace armature
