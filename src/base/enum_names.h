// SPDX-License-Identifier: BSD-3-Clause
// Names of enumerations, in one table each: what options, messages and files call a value.
//
//   enum class Wood { kOak, kPine };
//   template <>
//   struct EnumNames<Wood> {
//     static constexpr NamedValue<Wood> kTable[] = {{Wood::kOak, "oak"}, {Wood::kPine, "pine"}};
//   };
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace armature {

template <typename Enum>
struct NamedValue {
  Enum value;
  const char* name;
};

template <typename Enum>
struct EnumNames;  // specialised beside each enumeration that has names

template <typename Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires {
  EnumNames<Enum>::kTable;
};

template <NamedEnum Enum>
const char* ToName(Enum value) {
  for (const NamedValue<Enum>& entry : EnumNames<Enum>::kTable) {
    if (entry.value == value) return entry.name;
  }
  std::abort();  // the table lacks a value
}

// None for an unknown name.
template <NamedEnum Enum>
std::optional<Enum> FromName(std::string_view name) {
  for (const NamedValue<Enum>& entry : EnumNames<Enum>::kTable) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

// In the order of the table.
template <NamedEnum Enum>
std::vector<std::string> ListNames() {
  std::vector<std::string> names;
  for (const NamedValue<Enum>& entry : EnumNames<Enum>::kTable) names.emplace_back(entry.name);
  return names;
}

}  // namespace armature
