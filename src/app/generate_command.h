// SPDX-License-Identifier: BSD-3-Clause
// `armature generate`: draws the embedded data.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>

namespace armature {

struct GenerateArguments {
  bool sample = false;
  std::filesystem::path out;  // sequence folder to write
  int frames = 24;
  std::uint64_t seed = 1;
};

// Writes the sequence and says where it is. Returns the exit status; throws InputError.
int RunGenerate(const GenerateArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunGenerate and stores the exit status.
void AddGenerateCommand(CLI::App& app, int& exit_status);

}  // namespace armature
