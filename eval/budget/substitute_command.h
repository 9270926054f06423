// SPDX-License-Identifier: BSD-3-Clause
// `armature substitute`: sequences with a part of the truth in them.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/configuration.h"

namespace armature {

struct SubstituteArguments {
  std::vector<std::filesystem::path> sequences;
  std::vector<std::string> truths;  // names of SubstitutedTruth
  std::filesystem::path out;
  ConfigurationArguments configuration;  // its folder of category models
};

// Reads and checks everything before the first folder is written. Returns the exit status; throws InputError.
int RunSubstitute(const SubstituteArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunSubstitute and stores the exit status.
void AddSubstituteCommand(CLI::App& app, int& exit_status);

}  // namespace armature
