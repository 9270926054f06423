// SPDX-License-Identifier: BSD-3-Clause
// What goes with errors: circumstances of objects and rooms against the errors of their centres.
#pragma once

#include "eval/rooms/room_evaluation.h"
#include "io/text_table.h"

namespace armature {

// A row a circumstance: Spearman's rank correlation with the centre's error, over found objects or over rooms
// (their mean error), with its interval over rooms; medians of the error and missed objects by thirds of the
// circumstance.
Table RoomFactorTable(const RoomVariant& variant);

// Kinds - categories, detection settings - with their errors.
Table RoomGroupTable(const RoomVariant& variant);

// A row a variant, room and object that could be seen: error and circumstances. CSV.
std::string RawRoomObjectsCsv(const std::vector<RoomVariant>& variants);

// A row a variant and room. CSV.
std::string RawRoomsCsv(const std::vector<RoomVariant>& variants);

}  // namespace armature
