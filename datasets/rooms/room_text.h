// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "datasets/rooms/drawn_room.h"

namespace armature {

// The scene file of a drawn room (datasets/README.md, "Scenes"): reading it gives the same scene.
std::string RoomText(const DrawnRoom& room);

}  // namespace armature
