// SPDX-License-Identifier: BSD-3-Clause
// Stamps as keys of maps: whole numbers compare exactly.
#pragma once

#include <cmath>

namespace armature {

inline long long Microseconds(double seconds) { return std::llround(seconds * 1e6); }

}  // namespace armature
