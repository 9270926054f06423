// SPDX-License-Identifier: BSD-3-Clause
// The program as a whole: help, version, presets.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

#include "cli/configuration.h"
#include "cli/option_settings.h"
#include "io/option_value.h"
#include "io/options_yaml.h"
#include "retrieval/retrieval_options.h"
#include "support/expect_input_error.h"
#include "support/program.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::RunOk;

TEST(AppProgram, HelpNamesEveryCommand) {
  const std::string help = RunOk({"--help"}).out;
  for (const std::string command : {"run", "photo", "eval", "learn", "generate"}) {
    EXPECT_NE(help.find("\n  " + command + " "), std::string::npos) << help;
  }
}

// In one line, as wrapping may have broken it.
std::string WithoutBreaks(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += word + " ";
  return line;
}

TEST(AppProgram, HelpOfACommandNamesEveryOption) {
  Options options;
  for (const std::string command : {"run", "photo"}) {
    const std::string help = WithoutBreaks(RunOk({command, "--help"}).out);
    for (const OptionEntry& entry : OptionTable(options)) {
      EXPECT_NE(help.find(fmt::format("{} {} ({}) [{}]", entry.key, entry.help, OptionDomain(entry),
                                      OptionText(entry))),
                std::string::npos)
          << entry.key;
    }
    EXPECT_NE(help.find("--preset"), std::string::npos);
  }
}

TEST(AppProgram, ExpertOptionsComeLast) {
  Options options;
  RetrievalOptions retrieval;
  for (const std::vector<OptionEntry>& table : {OptionTable(options), RetrievalOptionTable(retrieval)}) {
    const auto is_expert = [](const OptionEntry& entry) { return entry.key.starts_with("expert."); };
    EXPECT_TRUE(std::is_partitioned(table.begin(), table.end(), std::not_fn(is_expert)));
    const std::string help = DescribeOptions(table);
    const size_t heading = help.find("For studies");
    for (const OptionEntry& entry : table)
      EXPECT_EQ(help.find("  " + entry.key) > heading, is_expert(entry)) << entry.key;
  }
}

TEST(AppProgram, VersionIsOneLine) {
  const std::string version = RunOk({"--version"}).out;
  EXPECT_TRUE(version.starts_with("armature 0.")) << version;
  EXPECT_EQ(version.find('\n'), version.size() - 1);
}

TEST(AppProgram, BadUsageIsOneLine) {
  ExpectBadInput({}, {"subcommand", "armature --help"});
  ExpectBadInput({"rnu", "x"}, {"rnu", "'run'"});
  ExpectBadInput({"--bogus"}, {"--help"});
  ExpectBadInput({"generate"}, {"--out"});
}

TEST(AppPresets, AllCanBeLoaded) {
  std::set<std::string> different;
  for (const std::string preset : {"default", "paper", "paper_meant", "fast"}) {
    ConfigurationArguments arguments;
    arguments.preset = preset;
    Options options = LoadOptions(arguments), defaults;
    const std::string yaml = EffectiveYaml(OptionTable(options));
    EXPECT_EQ(yaml == EffectiveYaml(OptionTable(defaults)), preset == "default") << preset;
    EXPECT_TRUE(different.insert(yaml).second) << preset << " is another preset";
  }
}

TEST(AppPresets, SettingsComeAfterFilesAfterThePreset) {
  const testing::TempFolder folder;
  ConfigurationArguments arguments;
  arguments.preset = "paper";
  arguments.config = folder.Write("my.yaml", "association: {rounds: 3, refined_hypotheses: 3}\n");
  arguments.settings = {"association.rounds=2"};
  const Options options = LoadOptions(arguments);
  EXPECT_EQ(options.association.cost, AssociationCost::kPrinted);
  EXPECT_EQ(options.association.refined_hypotheses, 3);
  EXPECT_EQ(options.association.rounds, 2);
}

}  // namespace
}  // namespace armature
