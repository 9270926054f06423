// SPDX-License-Identifier: BSD-3-Clause
// Reading scene files (datasets/README.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/scene/scene.h"

namespace armature {

// The scene with its instances taken from the collection. Throws InputError naming file, line and remedy: for
// what cannot be read; for objects that are not in the collection, overlap, stick out of the room or over the
// edge of what they stand on; and for a camera that comes too near to anything on its path. `draw`: 1, the
// scene with its own seed; 2, 3, ...: with others, and with NameDraw as its name.
Scene ReadScene(const std::filesystem::path& file, const std::vector<CadInstance>& collection, int draw = 1);

}  // namespace armature
