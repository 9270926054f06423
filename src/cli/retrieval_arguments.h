// SPDX-License-Identifier: BSD-3-Clause
// How commands are told to retrieve.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "retrieval/retrieval_options.h"

namespace armature {

struct RetrievalArguments {
  std::filesystem::path config;       // a file of options; empty: none
  std::vector<std::string> settings;  // "retrieval.k=3"
};

// Adds --config and --set, and all options to the end of the help.
void AddRetrievalArguments(CLI::App& command, RetrievalArguments& arguments);

// The options after file and settings, checked. Throws InputError naming the file and line, or the setting.
RetrievalOptions LoadRetrievalOptions(const RetrievalArguments& arguments);

}  // namespace armature
