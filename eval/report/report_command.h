// SPDX-License-Identifier: BSD-3-Clause
// `armature report`: runs, their evaluation and benchmarks as one page to look at.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/configuration.h"
#include "eval/report/report_sources.h"

namespace armature {

struct ReportArguments {
  std::vector<std::filesystem::path> runs;          // run folders, or folders of such
  std::filesystem::path out;                        // the page
  std::vector<std::filesystem::path> ground_truth;  // as of `armature eval`
  std::vector<std::filesystem::path> evaluations;   // folders of `armature eval --out`; empty: evaluated here
  std::vector<std::filesystem::path> benches;       // folders of `armature bench --out`
  std::vector<std::filesystem::path> tables;        // JSON of other tables
  std::filesystem::path library;                    // file of instances; empty: none
  std::string title = "Armature: objects from lines";
  ConfigurationArguments configuration;  // its folder of category models
};

// Reads the tables or makes them, and finds the runs' sequences. Throws InputError.
ReportSources CollectSources(const ReportArguments& arguments);

// Writes the page and prints where it is. Returns the exit status; throws InputError.
int RunReport(const ReportArguments& arguments);

// Adds the sub-command; once it is parsed, its callback runs RunReport and stores the exit status.
void AddReportCommand(CLI::App& app, int& exit_status);

}  // namespace armature
