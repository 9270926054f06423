// SPDX-License-Identifier: BSD-3-Clause
// Options from configuration files and the command line, and back to text. The table of options is the only
// source.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/option_entry.h"

namespace armature {

// Sets the options that the file names; the file is nested maps ("association: {detector: lsd}") and may be
// partial. Throws InputError naming file and line for an unknown key (and the nearest known one), a value of
// another type, a number out of its range (both values are printed) or a name that is none of the value's.
// Options before the bad one remain set.
void ApplyYaml(const std::filesystem::path& file, const std::vector<OptionEntry>& entries);

// "key=value", as given to --set; the same checks.
void ApplySetting(const std::string& setting, const std::vector<OptionEntry>& entries);

// Checks the values that the fields have now, as after setting them in code. Throws InputError.
void CheckOptions(const std::vector<OptionEntry>& entries);

// All options with their values as nested YAML, in the order of the table. ApplyYaml of it restores the same
// values exactly.
std::string EffectiveYaml(const std::vector<OptionEntry>& entries);

}  // namespace armature
