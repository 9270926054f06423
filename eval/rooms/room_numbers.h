// SPDX-License-Identifier: BSD-3-Clause
// The numbers that a room is judged by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/rooms/room_evaluation.h"

namespace armature {

// What is summed up over rooms: a value an object or a room.
enum class RoomQuantity { kFound, kSpurious, kCentre, kScale, kAzimuth, kSize, kCamera };

// found, azimuth: 1 or 0 of each observed or found object, right within 15 degrees; spurious: one number;
// centre, size: metres of each found object; scale: |ln of estimated over true|; camera: rmse, metres. None
// of a room that has none.
std::vector<double> ValuesOf(const EvaluatedRoom& room, RoomQuantity quantity);

// How values become one.
enum class RoomSummary { kMean, kMedian, kP90, kWorst };

struct RoomStatistic {
  RoomQuantity quantity;
  RoomSummary summary;
  const char* key;    // in records
  const char* title;  // in tables
  double unit;        // of the table: 100 for percent
  int digits;
};

// In the order of the tables.
const std::vector<RoomStatistic>& RoomStatistics();

// Of the one room; none without values.
std::optional<double> NumberOf(const EvaluatedRoom& room, const RoomStatistic& statistic);

}  // namespace armature
