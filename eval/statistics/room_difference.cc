// SPDX-License-Identifier: BSD-3-Clause
#include "eval/statistics/room_difference.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace armature {
namespace {

constexpr size_t kFewestRooms = 6;  // as of pairs, see paired_difference.h
constexpr double kSignificance = 1.959964, kPower = 0.841621;
constexpr double kMostRooms = 1e6;

DifferenceMark MarkInterval(const Interval& interval, size_t rooms) {
  if (rooms < kFewestRooms) return DifferenceMark::kTooFew;
  if (interval.low > 0) return DifferenceMark::kHigher;
  return interval.high < 0 ? DifferenceMark::kLower : DifferenceMark::kSame;
}

}  // namespace

std::optional<RoomDifference> CompareRooms(const std::vector<std::pair<double, double>>& rooms) {
  if (rooms.empty()) return std::nullopt;
  RoomDifference result{.rooms = rooms.size()};
  std::vector<std::pair<double, size_t>> differences;
  std::vector<double> values;
  const double n = static_cast<double>(rooms.size());
  for (const auto& [a, b] : rooms) {
    result.mean_a += a / n;
    result.mean_b += b / n;
    differences.emplace_back(b - a, differences.size());
    values.push_back(b - a);
  }
  const auto statistics = ComputeStatistics(values);
  result.mean = statistics->mean;
  result.deviation = statistics->deviation;
  const ValuesInRooms in_rooms(differences);
  result.interval =
      RoomBootstrap(rooms.size()).Of([&](const RoomCounts& counts) { return in_rooms.Mean(counts); }).value();
  result.mark = MarkInterval(result.interval, rooms.size());
  return result;
}

std::optional<long> RoomsToShow(const RoomDifference& difference, double size) {
  if (!(size > 0) || difference.rooms < 2) return std::nullopt;
  const double root = (kSignificance + kPower) * difference.deviation / size;
  if (!(root * root <= kMostRooms)) return std::nullopt;
  return std::max(2L, static_cast<long>(std::ceil(root * root)));
}

}  // namespace armature
