// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_configuration.h"

#include <fmt/format.h>

#include "io/yaml_support.h"

namespace armature {
namespace {

void AddOptions(const YamlMap& map, const std::string& prefix, std::map<std::string, std::string>& options) {
  for (const std::string& key : map.Keys()) {
    if (map.IsMap(key)) {
      AddOptions(map.Map(key), prefix + key + ".", options);
    } else {
      options[prefix + key] =
          map.IsList(key) ? fmt::format("[{}]", fmt::join(map.Texts(key), ", ")) : map.Text(key);
    }
  }
}

}  // namespace

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

std::map<std::string, std::string> ReadOptionTexts(const std::filesystem::path& run) {
  std::map<std::string, std::string> options;
  const std::filesystem::path file = run / "config.yaml";
  if (std::filesystem::exists(file)) AddOptions(YamlMap::Load(file), "", options);
  return options;
}

}  // namespace armature
