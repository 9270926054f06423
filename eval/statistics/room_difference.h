// SPDX-License-Identifier: BSD-3-Clause
// How far two ways of running differ in the same rooms, and how many rooms would show it.
//
// Of each room the difference b - a of a number; the rooms' mean difference has the interval of
// RoomBootstrap. A difference d is seen, in a test at 5 % and in 80 of 100 repetitions, with
//   n = ((1.96 + 0.84) s / d)^2
// rooms, where s is the standard deviation of the rooms' differences (the sample size of a paired z-test).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/paired_difference.h"
#include "eval/statistics/room_bootstrap.h"

namespace armature {

struct RoomDifference {
  size_t rooms = 0;
  double mean_a = 0, mean_b = 0;
  double mean = 0;                              // of b - a
  Interval interval{};                          // of that
  DifferenceMark mark = DifferenceMark::kSame;  // too few: fewer than six rooms
  double deviation = 0;  // standard deviation of the rooms' differences, 0 of a single one
};

// A pair (a, b) a room. None of no room.
std::optional<RoomDifference> CompareRooms(const std::vector<std::pair<double, double>>& rooms);

// So many rooms would show a difference of that size, 2 at least; none where it is no size, or more than a
// million.
std::optional<long> RoomsToShow(const RoomDifference& difference, double size);

}  // namespace armature
