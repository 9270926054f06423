// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "datasets/scene/scene.h"

namespace armature {

// `room.clutter` things on the floor along the walls and `room.table_clutter` on each table, drawn with the
// scene's seed: where they overlap nothing, are in nobody's way and at least 0.3 m from the camera's path.
// Fewer where there is no space.
std::vector<ClutterPiece> ScatteredClutter(const Scene& scene);

}  // namespace armature
