// SPDX-License-Identifier: BSD-3-Clause
// The program as a whole: help, version, presets.
#include <gtest/gtest.h>

#include "cli/configuration.h"
#include "io/options_yaml.h"
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

TEST(AppProgram, HelpOfACommandNamesEveryOption) {
  Options options;
  for (const std::string command : {"run", "photo"}) {
    const std::string help = RunOk({command, "--help"}).out;
    for (const OptionEntry& entry : OptionTable(options)) {
      EXPECT_NE(help.find(entry.key + " "), std::string::npos) << entry.key;
      EXPECT_NE(help.find(entry.help), std::string::npos) << entry.key;
    }
    EXPECT_NE(help.find("--preset"), std::string::npos);
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
  for (const std::string preset : {"default", "paper", "fast"}) {
    ConfigurationArguments arguments;
    arguments.preset = preset;
    Options options = LoadOptions(arguments), defaults;
    const bool is_default = EffectiveYaml(OptionTable(options)) == EffectiveYaml(OptionTable(defaults));
    EXPECT_EQ(is_default, preset == "default") << preset;
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
