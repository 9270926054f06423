// SPDX-License-Identifier: BSD-3-Clause
#include "cli/option_settings.h"

#include "cli/help.h"

namespace armature {

std::vector<std::string> Keys(const std::vector<OptionEntry>& entries) {
  std::vector<std::string> keys;
  keys.reserve(entries.size());
  for (const OptionEntry& entry : entries) keys.push_back(entry.key);
  return keys;
}

void AddSettings(CLI::App& command, std::vector<std::string>& settings,
                 const std::vector<std::string>& keys) {
  std::vector<std::string> starts;
  for (const std::string& key : keys) starts.push_back(key + "=");
  OfferValues(
      *command.add_option("--set", settings, "then set one option (listed at the end); may be repeated")
           ->type_name("KEY=VALUE")
           ->allow_extra_args(false),
      starts);
}

}  // namespace armature
