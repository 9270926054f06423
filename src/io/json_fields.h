// SPDX-License-Identifier: BSD-3-Clause
// Plain structs as JSON objects, a key a member.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/errors.h"
#include "base/nearest_name.h"

// As NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE, for ordered_json: keys in the order of the list. A key that is
// missing is an nlohmann::json::exception that names it.
#define ARMATURE_JSON_FIELDS(Type, ...)                                                         \
  inline void to_json(nlohmann::ordered_json& nlohmann_json_j, const Type& nlohmann_json_t) {   \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))                    \
  }                                                                                             \
  inline void from_json(const nlohmann::ordered_json& nlohmann_json_j, Type& nlohmann_json_t) { \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_FROM, __VA_ARGS__))                  \
  }                                                                                             \
  static_assert(std::is_class_v<Type>)

// null: none. Its key has to be there all the same.
template <typename T>
struct nlohmann::adl_serializer<std::optional<T>> {
  template <typename Json>
  static void to_json(Json& json, const std::optional<T>& value) {
    if (value) {
      json = *value;
    } else {
      json = nullptr;
    }
  }
  template <typename Json>
  static void from_json(const Json& json, std::optional<T>& value) {
    value = json.is_null() ? std::nullopt : std::optional<T>(json.template get<T>());
  }
};

namespace armature {

// The value whose name stands at its place in the list. Throws InputError, which says `what` it is to be a
// name of: nlohmann's own macro takes an unknown name for the first value.
template <typename Enum, size_t n>
Enum EnumFromName(const std::array<const char*, n>& names, const char* what, const std::string& name) {
  for (size_t i = 0; i < n; ++i) {
    if (name == names[i]) return static_cast<Enum>(i);
  }
  throw InputError(UnknownNameMessage(what, name, std::vector<std::string>(names.begin(), names.end())));
}

}  // namespace armature
