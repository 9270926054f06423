// SPDX-License-Identifier: BSD-3-Clause
// `armature run`: sequences through the pipeline, a run folder each.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "cli/configuration.h"

namespace armature {

struct RunArguments {
  std::vector<std::filesystem::path> sequences;
  std::filesystem::path detections;  // a file, or a folder of <sequence name>.csv; empty: the sequences' own
  std::filesystem::path out;         // the run folder; with several sequences the folder of the run folders
  ConfigurationArguments configuration;
  bool overlays = false;
  std::filesystem::path video;  // file, with several sequences the folder of the files; empty: none
  bool pipelined = false;
  int jitter = 0;  // seed of changes that must not matter; 0: none
  int frames = 0;  // 0: all
  bool json = false;
};

// Reads and checks everything before the first sequence runs. Returns the exit status; throws InputError.
int RunRun(const RunArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunRun and stores the exit status.
void AddRunCommand(CLI::App& app, int& exit_status);

}  // namespace armature
