// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/rooms/recipe.h"
#include "datasets/scene/scene.h"

namespace armature {

// The room itself and its light: size, textures in colours that suit them, decoration, lamps.
void DrawLooks(const RoomRecipe& recipe, std::uint64_t seed, Scene* scene);

}  // namespace armature
