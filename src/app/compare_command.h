// SPDX-License-Identifier: BSD-3-Clause
// `armature compare`: results side by side, paired by what they are of.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/configuration.h"
#include "io/text_table.h"

namespace armature {

struct CompareArguments {
  // The first is A, each of the others is B once: run folders or folders of such, or all bench folders.
  std::vector<std::filesystem::path> results;
  std::vector<std::filesystem::path> ground_truth;  // as of EvalArguments
  std::string alignment = "first_pose";             // how cameras and maps are brought to the truth
  std::string format = "text";
  bool json = false;
  std::filesystem::path raw;             // file of a row a pair; empty: none
  ConfigurationArguments configuration;  // its folder of category models
};

// What comes out of comparing B with A.
struct Comparison {
  std::vector<Table> tables;
  std::vector<std::string> warnings;  // also notes of the tables
  std::string raw;                    // rows a pair, see RawPairColumns
};

// Prints the tables, and the warnings to standard error, too. Throws InputError: fewer than two results, a
// malformed or unfinished one, nothing in common.
int RunCompare(const CompareArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunCompare and stores the exit status.
void AddCompareCommand(CLI::App& app, int& exit_status);

}  // namespace armature
