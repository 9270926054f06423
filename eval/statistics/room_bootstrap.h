// SPDX-License-Identifier: BSD-3-Clause
// How sure a number is that was computed from rooms: the bootstrap over rooms (Efron 1979).
//
// Objects of one room share its camera, light and scale, so they are alike, and a room is the unit that is
// drawn: as many rooms as there are, with replacement, each with all that is in it. The interval of a
// statistic is from its 2.5th to its 97.5th percentile over many such draws (the percentile interval). Of few
// rooms it is too narrow, and of a greatest value it cannot reach beyond the greatest that was seen.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace armature {

// How often each room was drawn.
using RoomCounts = std::vector<int>;

struct Interval {
  double low = 0, high = 0;

  bool Contains(double value) const { return low <= value && value <= high; }
};

class RoomBootstrap {
 public:
  static constexpr size_t kRepeats = 2000;

  // The same draws for the same number of rooms and seed.
  explicit RoomBootstrap(size_t rooms, std::uint64_t seed = 1);

  // Each room once.
  RoomCounts Once() const { return RoomCounts(rooms_, 1); }

  // Of 95 in 100 draws. `statistic` has none where what was drawn has no value; none where it never has one.
  std::optional<Interval> Of(
      const std::function<std::optional<double>(const RoomCounts& counts)>& statistic) const;

 private:
  size_t rooms_;
  std::vector<RoomCounts> draws_;
};

// Values that are in rooms (errors of objects, numbers of rooms), to be summarised as often as the rooms are
// drawn. None of no value.
class ValuesInRooms {
 public:
  // Value and position of its room, less than the number of the counts below.
  explicit ValuesInRooms(std::vector<std::pair<double, size_t>> values);

  size_t size() const { return values_.size(); }
  std::optional<double> Mean(const RoomCounts& counts) const;
  // Linear between neighbours, as Quantile of base/statistics.h.
  std::optional<double> Quantile(const RoomCounts& counts, double fraction) const;

 private:
  std::vector<std::pair<double, size_t>> values_;  // by growing value
};

}  // namespace armature
