// SPDX-License-Identifier: BSD-3-Clause
#include "cli/configuration.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/console.h"
#include "base/errors.h"
#include "base/nearest_name.h"
#include "cli/data_folders.h"
#include "cli/help.h"
#include "cli/option_settings.h"
#include "io/category_yaml.h"
#include "io/options_yaml.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> PresetNames(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder, absent)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path PresetFile(const ConfigurationArguments& arguments) {
  const fs::path folder = ConfigsFolder(arguments.configs) / "presets";
  const std::vector<std::string> names = PresetNames(folder);
  if (names.empty()) {
    throw InputError(
        fmt::format("{}: has no preset; name the folder of configurations with --configs or in "
                    "ARMATURE_CONFIGS",
                    folder.string()));
  }
  if (std::find(names.begin(), names.end(), arguments.preset) == names.end()) {
    throw InputError(fmt::format("--preset: {}", UnknownNameMessage("preset", arguments.preset, names)));
  }
  return folder / (arguments.preset + ".yaml");
}

std::vector<std::string> OptionKeys() {
  Options options;
  return Keys(OptionTable(options));
}

std::string OptionsHelp() {
  Options options;
  return DescribeOptions(OptionTable(options));
}

}  // namespace

void AddConfigurationArguments(CLI::App& command, ConfigurationArguments& arguments) {
  BeginSection(command, "Configuration");
  KnownValues(*command.add_option("--preset", arguments.preset, "start from CONFIGS/presets/NAME.yaml")
                   ->type_name("NAME"),
              PresetNames(ConfigsFolder({}) / "presets"))
      .capture_default_str();
  command.add_option("--config", arguments.config, "then from a file of your own; it may be partial")
      ->type_name("FILE");
  AddSettings(command, arguments.settings, OptionKeys());
  command.add_option("--categories", arguments.categories, "folder of category models (CONFIGS/categories)")
      ->type_name("DIR");
  command.add_option("--configs", arguments.configs, "CONFIGS: folder of presets and categories")
      ->type_name("DIR");
  command.footer(OptionsHelp);
}

Options LoadOptions(const ConfigurationArguments& arguments) {
  Options options;
  const std::vector<OptionEntry> table = OptionTable(options);
  const fs::path preset = PresetFile(arguments);
  Detail("options from " + preset.string());
  ApplyYaml(preset, table);
  if (!arguments.config.empty()) {
    Detail("then from " + arguments.config.string());
    ApplyYaml(arguments.config, table);
  }
  for (const std::string& setting : arguments.settings) ApplySetting(setting, table);
  CheckOptions(table);
  return options;
}

std::map<std::string, Options> LoadPresets(const ConfigurationArguments& arguments) {
  std::map<std::string, Options> presets;
  const fs::path folder = ConfigsFolder(arguments.configs) / "presets";
  for (const std::string& name : PresetNames(folder)) {
    const std::vector<OptionEntry> table = OptionTable(presets[name]);
    ApplyYaml(folder / (name + ".yaml"), table);
    CheckOptions(table);
  }
  return presets;
}

std::vector<CategoryModel> LoadModels(const ConfigurationArguments& arguments) {
  const fs::path folder =
      arguments.categories.empty() ? ConfigsFolder(arguments.configs) / "categories" : arguments.categories;
  Detail("category models from " + folder.string());
  return LoadCategories(folder);
}

std::string ConfigurationText(const ConfigurationArguments& arguments, Options options) {
  std::string text = fmt::format("# Effective configuration. Preset: {}", arguments.preset);
  if (!arguments.config.empty()) text += fmt::format(", file: {}", arguments.config.filename().string());
  for (const std::string& setting : arguments.settings) text += fmt::format(", --set {}", setting);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + "\n" + EffectiveYaml(OptionTable(options));
}

std::vector<std::string> CategoryNames(const std::vector<CategoryModel>& models) {
  std::vector<std::string> names;
  names.reserve(models.size());
  for (const CategoryModel& model : models) names.push_back(model.spec.name);
  return names;
}

}  // namespace armature
