// SPDX-License-Identifier: BSD-3-Clause
// `armature bench`: how long the parts take, next to what they find.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/configuration.h"

namespace armature {

struct DetectorBenchArguments {
  std::vector<std::filesystem::path> sequences;
  std::filesystem::path cad;           // folder of annotated CAD models; empty: recall by edges_gt.csv alone
  std::vector<std::string> detectors;  // names; empty: all
  int frames = 0;                      // the first so many images; 0: all
  std::string format = "text";
  bool json = false;
  ConfigurationArguments configuration;  // its folder of category models
};

// Prints a table a sequence. Returns the exit status; throws InputError.
int RunDetectorBench(const DetectorBenchArguments& arguments);

// Adds the sub-command with its benchmarks; once one is parsed, its callback runs it and stores the exit
// status.
void AddBenchCommand(CLI::App& app, int& exit_status);

}  // namespace armature
