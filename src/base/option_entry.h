// SPDX-License-Identifier: BSD-3-Clause
// Options as data: one row an option, from which configuration files, --set and --help are read and written.
#pragma once

#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/enum_names.h"

namespace armature {

// A field that holds a value of an enumeration with names.
struct EnumField {
  void* field;
  const char* (*name)(const void* field);
  bool (*set)(void* field, const std::string& name);  // false, and left as it is: no value has the name
  std::vector<std::string> (*names)();
};

struct OptionEntry {
  std::string key;   // "lines.detector": maps of the configuration file, joined by dots
  std::string help;  // what it is, with the unit
  std::variant<double*, int*, bool*, EnumField> field;
  double min = -std::numeric_limits<double>::infinity();  // numbers only, inclusive
  double max = std::numeric_limits<double>::infinity();
};

// Rows of the table, a line each: Option("lines.min_length", &o.lines.min_length, "shortest segment, pixels",
// 0, 1000).
template <typename Number>
requires(std::is_same_v<Number, double> || std::is_same_v<Number, int>) OptionEntry
    Option(std::string key, Number* field, std::string help,
           double min = -std::numeric_limits<double>::infinity(),
           double max = std::numeric_limits<double>::infinity()) {
  return {std::move(key), std::move(help), field, min, max};
}

inline OptionEntry Option(std::string key, bool* field, std::string help) {
  return {.key = std::move(key), .help = std::move(help), .field = field};
}

template <NamedEnum Enum>
OptionEntry Option(std::string key, Enum* field, std::string help) {
  const EnumField by_name{field, [](const void* f) { return ToName(*static_cast<const Enum*>(f)); },
                          [](void* f, const std::string& name) {
                            const std::optional<Enum> value = FromName<Enum>(name);
                            if (value) *static_cast<Enum*>(f) = *value;
                            return value.has_value();
                          },
                          ListNames<Enum>};
  return {.key = std::move(key), .help = std::move(help), .field = by_name};
}

}  // namespace armature
