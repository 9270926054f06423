// SPDX-License-Identifier: BSD-3-Clause
#include "cli/option_settings.h"

#include <fmt/format.h>

#include "cli/help.h"
#include "cli/wrapped_text.h"
#include "io/option_value.h"

namespace armature {
namespace {

constexpr ColumnLayout kOptionLayout{2, 38, 100};

bool IsExpert(const OptionEntry& entry) { return entry.key.starts_with("expert."); }

// An empty line between stages.
std::string DescribeRows(const std::vector<OptionEntry>& entries, bool expert) {
  std::string text, stage;
  for (const OptionEntry& entry : entries) {
    if (IsExpert(entry) != expert) continue;
    const std::string of_entry = expert ? "expert" : entry.key.substr(0, entry.key.find('.'));
    if (!stage.empty() && of_entry != stage) text += '\n';
    stage = of_entry;
    text +=
        TwoColumns(entry.key, fmt::format("{} ({}) [{}]", entry.help, OptionDomain(entry), OptionText(entry)),
                   kOptionLayout);
  }
  return text;
}

}  // namespace

std::string DescribeOptions(const std::vector<OptionEntry>& entries) {
  std::string text =
      "Options: key, meaning (values) [default], for --set key=value or as nested maps for --config:\n" +
      DescribeRows(entries, false);
  const std::string expert = DescribeRows(entries, true);
  if (!expert.empty())
    text += "\nFor studies of the method itself; users of it need none of these:\n" + expert;
  return text;
}

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
