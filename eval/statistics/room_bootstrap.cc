// SPDX-License-Identifier: BSD-3-Clause
#include "eval/statistics/room_bootstrap.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "geometry/random.h"

namespace armature {
namespace {

constexpr double kLowFraction = 0.025, kHighFraction = 0.975;

RoomCounts DrawRooms(size_t rooms, Random& random) {
  RoomCounts counts(rooms, 0);
  for (size_t i = 0; i < rooms; ++i) {
    const auto room = static_cast<size_t>(random.Uniform(0, static_cast<double>(rooms)));
    ++counts[std::min(room, rooms - 1)];
  }
  return counts;
}

}  // namespace

RoomBootstrap::RoomBootstrap(size_t rooms, std::uint64_t seed) : rooms_(rooms) {
  Random random(seed);
  for (size_t i = 0; i < kRepeats; ++i) draws_.push_back(DrawRooms(rooms, random));
}

std::optional<Interval> RoomBootstrap::Of(
    const std::function<std::optional<double>(const RoomCounts& counts)>& statistic) const {
  std::vector<double> values;
  for (const RoomCounts& counts : draws_) {
    if (const auto value = statistic(counts)) values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  return Interval{*Quantile(values, kLowFraction), *Quantile(values, kHighFraction)};
}

ValuesInRooms::ValuesInRooms(std::vector<std::pair<double, size_t>> values) : values_(std::move(values)) {
  std::sort(values_.begin(), values_.end());
}

std::optional<double> ValuesInRooms::Mean(const RoomCounts& counts) const {
  double sum = 0;
  long n = 0;
  for (const auto& [value, room] : values_) {
    sum += counts[room] * value;
    n += counts[room];
  }
  if (n == 0) return std::nullopt;
  return sum / static_cast<double>(n);
}

std::optional<double> ValuesInRooms::Quantile(const RoomCounts& counts, double fraction) const {
  long n = 0;
  for (const auto& [value, room] : values_) n += counts[room];
  if (n == 0) return std::nullopt;
  const double position = fraction * static_cast<double>(n - 1);
  const long below = static_cast<long>(position);
  long passed = 0;
  std::optional<double> low;
  for (const auto& [value, room] : values_) {
    passed += counts[room];
    if (!low && passed > below) low = value;
    if (passed > std::min(below + 1, n - 1))
      return std::lerp(*low, value, position - static_cast<double>(below));
  }
  return low;
}

}  // namespace armature
