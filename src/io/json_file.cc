// SPDX-License-Identifier: BSD-3-Clause
#include "io/json_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/text.h"

namespace armature {
namespace {

constexpr int kMostJsonLevels = 64;
constexpr size_t kMostJsonBytes = 256 << 20;

}  // namespace

nlohmann::ordered_json ReadJson(const std::filesystem::path& file, const std::string& remedy) {
  const auto refuse = [&](const std::string& why) {
    return InputError(fmt::format("{}: {}; {}", file.string(), why, remedy));
  };
  const std::string text = ReadTextFile(file);
  if (text.size() > kMostJsonBytes) throw refuse(fmt::format("is larger than {} MB", kMostJsonBytes >> 20));
  // What copies and writes values goes down into them by calling itself.
  const auto check_depth = [&](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
    if (depth > kMostJsonLevels) throw refuse(fmt::format("is more than {} levels deep", kMostJsonLevels));
    return true;
  };
  try {
    return nlohmann::ordered_json::parse(text, check_depth);
  } catch (const nlohmann::ordered_json::parse_error& error) {
    throw refuse(fmt::format("is not JSON from byte {} on", error.byte));
  } catch (const nlohmann::ordered_json::out_of_range&) {
    throw refuse("has a number that is too large");
  }
}

nlohmann::ordered_json ReadJsonObject(const std::filesystem::path& file, const std::string& remedy) {
  nlohmann::ordered_json json = ReadJson(file, remedy);
  if (json.is_object()) return json;
  throw InputError(fmt::format("{}: is no JSON object, {{...}}; {}", file.string(), remedy));
}

std::optional<nlohmann::ordered_json> FindJsonObject(const std::filesystem::path& file) {
  try {
    return ReadJsonObject(file, "");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace armature
