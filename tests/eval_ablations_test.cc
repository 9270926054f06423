// SPDX-License-Identifier: BSD-3-Clause
// Every ablation changes options that exist, and really changes something.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "io/options_yaml.h"
#include "pipeline/options.h"

namespace armature {
namespace {

TEST(Ablations, ChangeTheDefaults) {
  Options defaults;
  const std::string unchanged = EffectiveYaml(OptionTable(defaults));
  int files = 0;
  const auto folder = std::filesystem::path(ARMATURE_SOURCE_DIR) / "configs" / "ablations";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    Options options;
    const std::vector<OptionEntry> table = OptionTable(options);
    ApplyYaml(entry.path(), table);
    CheckOptions(table);
    EXPECT_NE(EffectiveYaml(table), unchanged) << entry.path() << " changes nothing";
    ++files;
  }
  EXPECT_GE(files, 10);
}

}  // namespace
}  // namespace armature
