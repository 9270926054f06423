// SPDX-License-Identifier: BSD-3-Clause
// `armature retrieve`: libraries of CAD models, and the models nearest to the objects of runs.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/configuration.h"
#include "cli/retrieval_arguments.h"

namespace armature {

struct RetrieveArguments {
  std::vector<std::filesystem::path> runs;  // run folders, or folders of such
  std::filesystem::path library;            // file
  std::filesystem::path sequence;           // of the runs; empty: where each says
  RetrievalArguments retrieval;
  bool place = false;  // write the map with the models in it

  bool build = false;         // make a library instead
  std::filesystem::path cad;  // of the CAD models in this folder
  std::filesystem::path out;  // as this file
  bool save_index = false;    // and the indices beside it

  std::string format = "text";
  bool json = false;
  ConfigurationArguments configuration;  // its folder of category models
};

// Returns the exit status; throws InputError.
int RunRetrieve(const RetrieveArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunRetrieve and stores the exit status.
void AddRetrieveCommand(CLI::App& app, int& exit_status);

}  // namespace armature
