// SPDX-License-Identifier: BSD-3-Clause
// The sections of scenes that a recipe gives as they are, but for values that are drawn one by one.
#pragma once

#include "datasets/rooms/distribution.h"

namespace armature {

// A value, or a section of its own: lost: {share: [0, 0.1], seconds: 1}.
struct DrawnKey {
  std::string name;
  int line = 0;  // of the recipe, from 1
  Distribution values;
  std::vector<DrawnKey> inner;
};
using DrawnSection = std::vector<DrawnKey>;

// Whatever the keys are: scenes know them, see DrawnWithLinesKept.
DrawnSection ReadDrawnSection(const YamlMap& map);

// As a line of a scene file; empty for a section without keys.
std::string DrawSectionText(const std::string& name, const DrawnSection& section, Random& random);

// A scene of the drawn section alone, taken for the recipe: keys are on its lines, so that messages about
// what scenes do not allow name the line to mend.
YamlMap DrawnWithLinesKept(const std::filesystem::path& recipe, const std::string& name,
                           const DrawnSection& section, Random& random);

}  // namespace armature
