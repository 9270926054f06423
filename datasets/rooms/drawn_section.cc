// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/drawn_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace armature {
namespace {

// `name: value, name: value`, each on its line of the recipe at `line` or after, which then is that line.
std::string FlowText(const DrawnSection& section, Random& random, int* line) {
  std::string text;
  for (const DrawnKey& key : section) {
    if (!text.empty()) text += ", ";
    text += std::string(static_cast<size_t>(std::max(0, key.line - *line)), '\n');
    *line = std::max(*line, key.line);
    text += key.name + ": ";
    text += key.inner.empty() ? DrawText(key.values, random)
                              : fmt::format("{{{}}}", FlowText(key.inner, random, line));
  }
  return text;
}

}  // namespace

DrawnSection ReadDrawnSection(const YamlMap& map) {
  DrawnSection section;
  for (const std::string& name : map.Keys()) {
    DrawnKey key;
    key.name = name;
    key.line = map.Line(name);
    if (map.IsMap(name) && !IsDistribution(map.Map(name)))
      key.inner = ReadDrawnSection(map.Map(name));
    else
      key.values = ReadAny(map, name);
    section.push_back(key);
  }
  return section;
}

std::string DrawSectionText(const std::string& name, const DrawnSection& section, Random& random) {
  if (section.empty()) return "";
  int line = std::numeric_limits<int>::max();  // all on one
  return fmt::format("{}: {{{}}}\n", name, FlowText(section, random, &line));
}

YamlMap DrawnWithLinesKept(const std::filesystem::path& recipe, const std::string& name,
                           const DrawnSection& section, Random& random) {
  int line = 1;
  return YamlMap::Parse(fmt::format("{}: {{{}}}\n", name, FlowText(section, random, &line)), recipe);
}

}  // namespace armature
