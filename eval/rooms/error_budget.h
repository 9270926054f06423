// SPDX-License-Identifier: BSD-3-Clause
// What each part of a room's error costs: runs with that part replaced by the truth (`armature substitute`)
// against the run without.
#pragma once

#include "eval/rooms/room_evaluation.h"
#include "io/text_table.h"

namespace armature {

// Mean over the objects of `as_it_is` that could be seen of how far `room` has them off, where a missed or
// spurious one counts as far off as the gate. Objects that can no longer be seen once their detections are
// left out count as missed: the same ones are judged in both.
double ErrorOfSameObjects(const EvaluatedRoom& as_it_is, const EvaluatedRoom& room, double gate_m);

// A row a variant over the rooms that it and the first one have, with what it gains on that; then the same of
// the rooms of each detection setting, where there are several.
Table ErrorBudgetTable(const std::vector<RoomVariant>& variants, double gate_m);

}  // namespace armature
