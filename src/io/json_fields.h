// SPDX-License-Identifier: BSD-3-Clause
// Values of JSON objects taken by their type, and plain structs as objects, a key a member.
#pragma once

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"

// As NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE, for ordered_json: keys in the order of the list. Reading is
// JsonField for each of them.
#define ARMATURE_JSON_READ(field) \
  nlohmann_json_t.field = ::armature::JsonField<decltype(nlohmann_json_t.field)>(nlohmann_json_j, #field);
#define ARMATURE_JSON_FIELDS(Type, ...)                                                         \
  inline void to_json(nlohmann::ordered_json& nlohmann_json_j, const Type& nlohmann_json_t) {   \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))                    \
  }                                                                                             \
  inline void from_json(const nlohmann::ordered_json& nlohmann_json_j, Type& nlohmann_json_t) { \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(ARMATURE_JSON_READ, __VA_ARGS__))                  \
  }                                                                                             \
  static_assert(std::is_class_v<Type>)

// null: none. Reading is JsonAs.
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
};

namespace armature {

template <typename T>
inline constexpr bool kIsVector = false;
template <typename T>
inline constexpr bool kIsVector<std::vector<T>> = true;
template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

// What a value of the type is called, and whether one is: nlohmann's get() takes -1 for a count, 1e30 for an
// int, true for a number.
template <typename T>
std::pair<const char*, bool> JsonTypeCheck(const nlohmann::ordered_json& value) {
  if constexpr (std::same_as<T, bool>) {
    return {"true or false", value.is_boolean()};
  } else if constexpr (std::same_as<T, std::string> || std::is_enum_v<T>) {
    return {"a text", value.is_string()};
  } else if constexpr (std::floating_point<T>) {
    return {"a number", value.is_number()};
  } else if constexpr (std::integral<T>) {
    const bool fits = value.is_number_unsigned()
                          ? std::in_range<T>(value.get<std::uint64_t>())
                          : value.is_number_integer() && std::in_range<T>(value.get<std::int64_t>());
    return {std::unsigned_integral<T> ? "a count" : "a whole number", fits};
  } else if constexpr (kIsVector<T>) {
    return {"a list", value.is_array()};
  } else {
    return {"an object", value.is_object()};
  }
}

// The value as a T: text, number, truth, list or optional of such (null: none), or a type that has from_json.
// Throws InputError, "`what` has to be a number, not '[1]'", without a file's name.
template <typename T>
T JsonAs(const nlohmann::ordered_json& value, const std::string& what) {
  if constexpr (kIsOptional<T>) {
    if (value.is_null()) return std::nullopt;
    return JsonAs<typename T::value_type>(value, what);
  } else {
    const auto [type, fits] = JsonTypeCheck<T>(value);
    if (!fits) {
      const std::string is = value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
      throw InputError(fmt::format("{} has to be {}, not {}", what, type, Quoted(is)));
    }
    if constexpr (kIsVector<T>) {
      T list;
      for (const auto& entry : value)
        list.push_back(JsonAs<typename T::value_type>(entry, fmt::format("{}[{}]", what, list.size())));
      return list;
    } else {
      return value.get<T>();
    }
  }
}

// A member that has to be there. Throws InputError, "'key' is missing" or as JsonAs.
template <typename T>
T JsonField(const nlohmann::ordered_json& object, const char* key) {
  if (!object.is_object()) throw InputError(fmt::format("{} has to be a member of an object", Quoted(key)));
  const auto found = object.find(key);
  if (found == object.end()) throw InputError(fmt::format("{} is missing", Quoted(key)));
  return JsonAs<T>(*found, Quoted(key));
}

// The same of one that may be missing.
template <typename T>
T JsonFieldOr(const nlohmann::ordered_json& object, const char* key, T otherwise) {
  const bool is_there = object.is_object() && object.contains(key);
  return is_there ? JsonField<T>(object, key) : otherwise;
}

// A member that is itself an object, or a list.
inline const nlohmann::ordered_json& JsonMember(const nlohmann::ordered_json& object, const char* key,
                                                nlohmann::ordered_json::value_t type) {
  const bool is_there = object.is_object() && object.contains(key) && object.at(key).type() == type;
  if (is_there) return object.at(key);
  const bool is_list = type == nlohmann::ordered_json::value_t::array;
  throw InputError(fmt::format("{} has to be there, as {}", Quoted(key), is_list ? "a list" : "an object"));
}
inline const nlohmann::ordered_json& JsonObject(const nlohmann::ordered_json& object, const char* key) {
  return JsonMember(object, key, nlohmann::ordered_json::value_t::object);
}
inline const nlohmann::ordered_json& JsonList(const nlohmann::ordered_json& object, const char* key) {
  return JsonMember(object, key, nlohmann::ordered_json::value_t::array);
}

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
