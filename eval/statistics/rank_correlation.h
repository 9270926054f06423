// SPDX-License-Identifier: BSD-3-Clause
// What grows with what: Spearman's rank correlation, and medians by thirds.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "eval/statistics/room_bootstrap.h"

namespace armature {

// A pair of numbers that is in a room.
struct PairInRoom {
  double x = 0, y = 0;
  size_t room = 0;
};

// Pearson's correlation of the ranks, equal values sharing the mean of their ranks; -1..1. To be computed as
// often as rooms are drawn, in linear time.
class RankCorrelation {
 public:
  explicit RankCorrelation(const std::vector<PairInRoom>& pairs);

  // None of fewer than three pairs, or where all x or all y are equal.
  std::optional<double> Of(const RoomCounts& counts) const;

 private:
  std::vector<double> Ranks(const std::vector<size_t>& order, double PairInRoom::*value,
                            const RoomCounts& counts) const;

  std::vector<PairInRoom> pairs_;
  std::vector<size_t> by_x_, by_y_;  // positions of the pairs by growing value
};

// The pairs with x up to its first third, up to its second, and above, as nearly as it goes: equal x stay
// together, so that thirds differ in number and one can be empty.
struct Thirds {
  std::array<double, 2> bounds{};                  // of x
  std::array<std::optional<double>, 3> medians{};  // of y
  std::array<std::optional<double>, 3> means{};    // of y
};

// None of no pair.
std::optional<Thirds> SplitByThirds(const std::vector<PairInRoom>& pairs);

}  // namespace armature
