// SPDX-License-Identifier: BSD-3-Clause
// --set KEY=VALUE, wherever single options can be set.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "base/option_entry.h"

namespace armature {

// What --help lists at its end: each option's key, meaning, values and default, those under "expert." last.
std::string DescribeOptions(const std::vector<OptionEntry>& entries);

std::vector<std::string> Keys(const std::vector<OptionEntry>& entries);

// Adds --set; the shell offers the keys.
void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::vector<std::string>& keys);

}  // namespace armature
