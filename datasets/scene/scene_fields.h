// SPDX-License-Identifier: BSD-3-Clause
// Values of a scene file with their checks. All throw InputError naming file, line and remedy.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/option_entry.h"
#include "drawing/mesh.h"
#include "io/yaml_support.h"

namespace armature {

// Sets the fields whose keys the map has. Other keys than theirs and `more_keys` are errors.
void ReadFields(const YamlMap& map, const std::vector<OptionEntry>& fields,
                const std::vector<std::string>& more_keys = {});

// Sets one field if the map has its key.
void ReadField(const YamlMap& map, const OptionEntry& field);

Eigen::Vector2d ReadPair(const YamlMap& map, const std::string& key);
Eigen::Vector3d ReadTriple(const YamlMap& map, const std::string& key);
// Three lengths greater than 0.
Eigen::Vector3d ReadSize(const YamlMap& map, const std::string& key);
// Red, green, blue, each 0..1.
Colour ReadColour(const YamlMap& map, const std::string& key);

// A word of letters, digits, '-' and '_': it names folders and stands in tables.
std::string ReadName(const YamlMap& map, const std::string& key);

// A list of maps; empty when the key is absent.
std::vector<YamlMap> MapsIfAny(const YamlMap& map, const std::string& key);

}  // namespace armature
