// SPDX-License-Identifier: BSD-3-Clause
// How a command is configured: preset, then configuration file, then single settings; and which categories it
// knows.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "pipeline/options.h"

namespace armature {

struct ConfigurationArguments {
  std::string preset = "default";     // a file of CONFIGS/presets
  std::filesystem::path config;       // a file of one's own; empty: none
  std::vector<std::string> settings;  // "key=value"
  std::filesystem::path categories;   // folder of category models; empty: CONFIGS/categories
  std::filesystem::path configs;      // CONFIGS; empty: see cli/data_folders.h
};

// Adds --preset, --config, --set, --categories and --configs, and all options to the end of the help.
void AddConfigurationArguments(CLI::App& command, ConfigurationArguments& arguments);

// The options after preset, file and settings, checked. Throws InputError naming the file and line, or the
// setting.
Options LoadOptions(const ConfigurationArguments& arguments);

// Every preset by name, alone: without file and settings. Throws InputError.
std::map<std::string, Options> LoadPresets(const ConfigurationArguments& arguments);

// The category models, sorted by file name. Throws InputError.
std::vector<CategoryModel> LoadModels(const ConfigurationArguments& arguments);

// What config.yaml of a run says: where the options came from, and all their values.
std::string ConfigurationText(const ConfigurationArguments& arguments, Options options);

// Names of the models' categories.
std::vector<std::string> CategoryNames(const std::vector<CategoryModel>& models);

}  // namespace armature
