// SPDX-License-Identifier: BSD-3-Clause
// Where and by what runs were made.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace armature {

using EnvironmentEntries = std::vector<std::pair<std::string, std::string>>;

// What summary.json of the run folder says of program, versions and machine. Throws InputError: missing or
// malformed.
EnvironmentEntries RunEnvironment(const std::filesystem::path& run);

// Adds what is new; another value of a known entry goes behind it.
void MergeEnvironment(const EnvironmentEntries& more, EnvironmentEntries& all);

}  // namespace armature
