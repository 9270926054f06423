// SPDX-License-Identifier: BSD-3-Clause
#include "eval/run_configuration.h"

#include "io/yaml_support.h"

namespace armature {

RunConfiguration ReadRunConfiguration(const std::filesystem::path& run) {
  RunConfiguration configuration;
  if (!std::filesystem::exists(run / "config.yaml")) return configuration;
  const YamlMap root = YamlMap::Load(run / "config.yaml");
  if (root.Has("resection") && root.Map("resection").Has("normal_term"))
    configuration.normal_term = root.Map("resection").Text("normal_term");
  if (root.Has("mapping") && root.Map("mapping").Has("loop_closure"))
    configuration.loop_closure = root.Map("mapping").Boolean("loop_closure");
  return configuration;
}

}  // namespace armature
