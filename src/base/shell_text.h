// SPDX-License-Identifier: BSD-3-Clause
// Commands as they can be typed.
#pragma once

#include <string>
#include <vector>

namespace armature {

// "armature run ... --out 'my runs'": what a shell would change is quoted.
std::string ShellText(const std::vector<std::string>& arguments);

}  // namespace armature
