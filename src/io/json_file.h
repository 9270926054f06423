// SPDX-License-Identifier: BSD-3-Clause
// JSON files that this program, another version of it, or anyone else wrote.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace armature {

// The file's one value; `remedy` ends the messages. Throws InputError when the file cannot be read, is not
// JSON, or is nested deeper than anything that is written here.
nlohmann::ordered_json ReadJson(const std::filesystem::path& file, const std::string& remedy);

// The same of a file that has to hold an object.
nlohmann::ordered_json ReadJsonObject(const std::filesystem::path& file, const std::string& remedy);

// None of a file that is not there, cannot be read or is no such object.
std::optional<nlohmann::ordered_json> FindJsonObject(const std::filesystem::path& file);

}  // namespace armature
