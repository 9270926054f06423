// SPDX-License-Identifier: BSD-3-Clause
// The rooms in which a variant does worst, and what is wrong there.
#pragma once

#include <string>
#include <vector>

#include "eval/rooms/room_evaluation.h"
#include "io/text_table.h"

namespace armature {

inline constexpr size_t kWorstRooms = 10;

// By the mean error of the objects that could be seen, where a missed or spurious one counts as far off as
// the gate; worst first, kWorstRooms at most.
std::vector<WorstRoomRecord> FindWorstRooms(const RoomVariant& variant, double gate_m);

// "2 of 7 missed, 1 spurious, scale 1.31 times, chair-3 0.61 m off": what is out of the ordinary.
std::string DescribeFaults(const EvaluatedRoom& room);

Table WorstRoomTable(const RoomVariant& variant, double gate_m);

}  // namespace armature
