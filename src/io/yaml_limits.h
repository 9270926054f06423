// SPDX-License-Identifier: BSD-3-Clause
// What a YAML file may be before it is loaded: a few bytes of aliases can stand for more than memory holds.
#pragma once

#include <filesystem>
#include <string>

namespace armature {

// Throws InputError naming file and line: more bytes, nodes (aliases written out) or levels than settings can
// need, an alias inside of what it stands for, a second document, a character that YAML does not allow, or
// text that is not YAML.
void CheckYaml(const std::string& content, const std::filesystem::path& file);

}  // namespace armature
