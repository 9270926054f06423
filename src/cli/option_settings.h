// SPDX-License-Identifier: BSD-3-Clause
// --set KEY=VALUE, wherever single options can be set.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "base/option_entry.h"

namespace armature {

std::vector<std::string> Keys(const std::vector<OptionEntry>& entries);

// Adds --set; the shell offers the keys.
void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::vector<std::string>& keys);

}  // namespace armature
