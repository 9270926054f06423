// SPDX-License-Identifier: BSD-3-Clause
#include "cli/retrieval_arguments.h"

#include "cli/option_settings.h"
#include "io/options_yaml.h"

namespace armature {

void AddRetrievalArguments(CLI::App& command, RetrievalArguments& arguments) {
  command.add_option("--config", arguments.config, "options from a file; it may be partial")
      ->type_name("FILE");
  RetrievalOptions defaults;
  AddSettings(command, arguments.settings, Keys(RetrievalOptionTable(defaults)));
  command.footer([] {
    RetrievalOptions options;
    return DescribeOptions(RetrievalOptionTable(options));
  });
}

RetrievalOptions LoadRetrievalOptions(const RetrievalArguments& arguments) {
  RetrievalOptions options;
  const std::vector<OptionEntry> table = RetrievalOptionTable(options);
  if (!arguments.config.empty()) ApplyYaml(arguments.config, table);
  for (const std::string& setting : arguments.settings) ApplySetting(setting, table);
  CheckOptions(table);
  return options;
}

}  // namespace armature
