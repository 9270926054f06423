// SPDX-License-Identifier: BSD-3-Clause
// Naming what was probably meant by an unknown name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace armature {

// The least number of inserted, deleted, replaced or swapped neighbouring characters that turns `a` into `b`.
int EditDistance(std::string_view a, std::string_view b);

// The known name nearest to `name`, large and small letters alike, the first of equals; a known dotted name
// may be meant by its last part, alone or in another group. Empty when nothing is known.
std::string NearestName(const std::string& name, const std::vector<std::string>& known);

// "unknown WHAT 'name'; did you mean 'nearest'?", followed by the known names when they are few.
std::string UnknownNameMessage(const std::string& what, const std::string& name,
                               const std::vector<std::string>& known);

}  // namespace armature
