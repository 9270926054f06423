// SPDX-License-Identifier: BSD-3-Clause
// Rooms from a recipe.
#pragma once

#include <cstdint>
#include <string>

#include "datasets/rooms/drawn_room.h"
#include "datasets/rooms/furniture_choice.h"
#include "datasets/rooms/recipe.h"

namespace armature {

struct RoomNumber {
  std::uint64_t seed = 1;
  int number = 0;    // of the room, from 0
  std::string name;  // of the scene
};

// The same for the same recipe, furniture, seed and number, whatever other rooms are drawn. Objects that the
// path does not show are left out, and a room of which fewer than three (or than there are) are seen is drawn
// again, up to 20 times. Throws InputError after that.
DrawnRoom DrawRoom(const Recipe& recipe, const Furniture& furniture, const RoomNumber& which);

}  // namespace armature
