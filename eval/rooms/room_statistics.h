// SPDX-License-Identifier: BSD-3-Clause
// Variants over rooms: what each reaches, with intervals, and how they differ in the same rooms.
#pragma once

#include <string>
#include <vector>

#include "eval/rooms/room_evaluation.h"
#include "io/text_table.h"

namespace armature {

// A record a variant and statistic; each variant over the rooms that it has.
std::vector<RoomStatisticRecord> ComputeRoomStatistics(const std::vector<RoomVariant>& variants);

// A row a variant.
Table RoomTable(const std::vector<RoomVariant>& variants, const std::vector<RoomStatisticRecord>& records);

// Of two variants, a record a number that a room has, over the rooms that both have and where both have the
// number.
std::vector<RoomDifferenceRecord> CompareVariants(const RoomVariant& a, const RoomVariant& b);

// A row a record.
Table RoomDifferenceTable(const std::vector<RoomDifferenceRecord>& records);

// The errors of each variant's objects, for pictures.
std::vector<RoomErrorsRecord> CollectRoomErrors(const std::vector<RoomVariant>& variants);

}  // namespace armature
