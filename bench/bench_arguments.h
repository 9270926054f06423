// SPDX-License-Identifier: BSD-3-Clause
// What `armature bench` was told, and the same in bench.json, so that a later call can repeat it.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "cli/configuration.h"

namespace armature {

struct BenchArguments {
  std::vector<std::filesystem::path> sequences;
  std::vector<std::string> tables;   // names; empty: all
  std::vector<std::string> engines;  // names; empty: bench/engines.h's default
  std::vector<std::string> micro;    // names of micro-benchmarks or families; empty: all
  std::vector<std::string> retrieval_sizes = {"1000", "10000", "100000", "1000000"};  // instances
  int frames = 0;  // the first so many images; 0: all
  int warm_up = 5;
  int repeat = 1;
  int threads = 1;
  int objects = 3;                // of the frames that the comparison is of
  int baseline_frames = 20;       // about so many are given to a baseline
  std::filesystem::path cad;      // folder of annotated CAD models; empty: recall by edges_gt.csv alone
  std::filesystem::path against;  // a bench.json to be compared with; empty: none
  std::filesystem::path out;      // folder of results; empty: only printed
  bool no_plots = false;
  std::string format = "text";
  bool json = false;
  ConfigurationArguments configuration;
  std::set<std::string> given;  // settings (see KeptArgument) that the command line names
};

// An argument that bench.json keeps.
struct KeptArgument {
  const char* option;   // "--warm-up"
  const char* setting;  // "warm_up"
  std::variant<int*, std::string*, std::filesystem::path*, std::vector<std::string>*,
               std::vector<std::filesystem::path>*>
      field;  // of the arguments
};

// All of them: what decides what is measured.
std::vector<KeptArgument> KeptArguments(BenchArguments& arguments);

// {"sequences": [...], "tables": [...], ..., "categories": FOLDER, "options": {KEY: TEXT}}
nlohmann::ordered_json SettingsJson(BenchArguments arguments, Options options);

// Takes what was not given from the "settings" of the reference, a bench.json that was read already. Paths
// are as they were given then. Throws InputError when a setting is not there or of another kind, or a folder
// that it names is not there.
void TakeReferenceSettings(BenchArguments& arguments);

}  // namespace armature
