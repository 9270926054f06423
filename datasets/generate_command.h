// SPDX-License-Identifier: BSD-3-Clause
// `armature generate`: makes the embedded data.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/generate.h"

namespace armature {

struct GenerateArguments {
  std::filesystem::path out;                       // gets cad/ and a folder a sequence
  std::vector<std::filesystem::path> scenes;       // of the user's; none: the shipped ones
  std::vector<std::string> only;                   // names of shipped scenes; none: kDefaultScenes
  std::filesystem::path rooms;                     // a recipe to draw rooms from instead; empty: none
  int count = 0, first = 0;                        // of the rooms
  std::string split;                               // development, check; empty: development, or the seed
  std::optional<int> seed;                         // of the rooms
  std::vector<std::filesystem::path> collections;  // folders of CAD models that scenes may name
  bool without_cad = false;
  SequenceOptions sequence;
};

// Makes what is not there yet and says where everything is. Returns the exit status; throws InputError.
int RunGenerate(const GenerateArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunGenerate and stores the exit status.
void AddGenerateCommand(CLI::App& app, int& exit_status);

}  // namespace armature
