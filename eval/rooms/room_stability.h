// SPDX-License-Identifier: BSD-3-Clause
// How far results move by changes that must not matter (run --jitter).
#pragma once

#include <vector>

#include "eval/rooms/room_evaluation.h"
#include "io/text_table.h"

namespace armature {

// The repeats of a variant: its own runs and those named <name>-<seed> that had this jitter.
struct RepeatedVariant {
  std::string name;
  std::vector<RoomVariant> repeats;
};

// Takes jittered variants out of the list and puts them to those that they repeat, in the order of the list.
// A variant without repeats is not among the result. A jittered one that repeats none of the list is a
// variant of its own.
std::vector<RepeatedVariant> TakeRepeats(std::vector<RoomVariant>& variants);

// A row a variant: medians over rooms of what its repeats scatter by.
Table StabilityTable(const std::vector<RepeatedVariant>& variants);

}  // namespace armature
