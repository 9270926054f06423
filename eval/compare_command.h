// SPDX-License-Identifier: BSD-3-Clause
// `armature compare`: results side by side, paired by what they are of.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/comparison.h"
#include "cli/configuration.h"

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

// Prints the tables, and the warnings to standard error, too. Throws InputError: fewer than two results, a
// malformed or unfinished one, nothing in common.
int RunCompare(const CompareArguments& arguments, const CompareFolders& compare_benches);

// Adds the sub-command; once it is parsed, its callback runs RunCompare and stores the exit status.
// `compare_benches` compares folders of `armature bench`.
void AddCompareCommand(CLI::App& app, const CompareFolders& compare_benches, int& exit_status);

}  // namespace armature
