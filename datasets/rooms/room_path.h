// SPDX-License-Identifier: BSD-3-Clause
// How a camera moves through a drawn room.
#pragma once

#include <optional>

#include "datasets/rooms/drawn_room.h"
#include "datasets/rooms/recipe.h"

namespace armature {

// A path of the recipe's kind that keeps away from walls and furniture; none where this draw leads into
// something. Loops and turns are those of scenes, everything else keyframes.
std::optional<CameraPath> TryPath(const PathRecipe& recipe, const DrawnRoom& room, Random& random);

}  // namespace armature
