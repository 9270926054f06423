// SPDX-License-Identifier: BSD-3-Clause
// One option's value from text and back.
#pragma once

#include <string>

#include "base/option_entry.h"

namespace armature {

// Parses and checks the text, then sets the field. Throws InputError("`where`: ...").
void SetOption(const OptionEntry& entry, const std::string& text, const std::string& where);

// Checks the range of the field's value. Throws InputError("`where`: ...").
void CheckOption(const OptionEntry& entry, const std::string& where);

// The value as a YAML scalar from which SetOption restores it exactly.
std::string OptionText(const OptionEntry& entry);

// "0..90", ">= 0", "lsd|edlines", "true|false"
std::string OptionDomain(const OptionEntry& entry);

}  // namespace armature
