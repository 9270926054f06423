// SPDX-License-Identifier: BSD-3-Clause
// `armature bench`: how long the parts take, next to what they find.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/configuration.h"

namespace armature {

struct BenchArguments {
  std::vector<std::filesystem::path> sequences;
  std::vector<std::string> tables;   // names; empty: all
  std::vector<std::string> engines;  // names; empty: bench/engines.h's default
  int frames = 0;                    // the first so many images; 0: all
  int warm_up = 5;
  int repeat = 1;
  int threads = 1;
  int objects = 3;            // of the frames that the comparison is of
  int baseline_frames = 20;   // about so many are given to a baseline
  std::filesystem::path cad;  // folder of annotated CAD models; empty: recall by edges_gt.csv alone
  std::filesystem::path out;  // folder of results; empty: only printed
  std::string format = "text";
  bool json = false;
  ConfigurationArguments configuration;
};

// Reads and checks everything before the first clock starts, then prints the tables. Returns the exit status;
// throws InputError.
int RunBench(const BenchArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunBench and stores the exit status.
void AddBenchCommand(CLI::App& app, int& exit_status);

}  // namespace armature
