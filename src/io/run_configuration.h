// SPDX-License-Identifier: BSD-3-Clause
// What a finished run was configured to do, as far as tables tell it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace armature {

// Options that config.yaml does not name are none: the run is older than the option.
struct RunConfiguration {
  std::optional<std::string> normal_term;  // resection.normal_term
  std::optional<bool> loop_closure;        // mapping.loop_closure
};

// config.yaml of a run folder; without the file nothing is known. Throws InputError: malformed.
RunConfiguration ReadRunConfiguration(const std::filesystem::path& run);

// Every option of config.yaml as written, by its full key ("mapping.loop_closure"); none without the file.
// Throws InputError: malformed.
std::map<std::string, std::string> ReadOptionTexts(const std::filesystem::path& run);

}  // namespace armature
