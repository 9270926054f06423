// SPDX-License-Identifier: BSD-3-Clause
// What stands where: groups of furniture and distractors.
#pragma once

#include "datasets/rooms/drawn_room.h"
#include "datasets/rooms/furniture_choice.h"
#include "datasets/rooms/recipe.h"

namespace armature {

// Places the recipe's groups, then distractors and things on seats. A place is drawn up to 40 times until the
// thing overlaps nothing and is inside of the room; what finds none is left out. `seed`: of the layout; each
// group and distractor has a stream of its own.
void DrawLayout(const Recipe& recipe, const Furniture& furniture, std::uint64_t seed, DrawnRoom* room);

}  // namespace armature
