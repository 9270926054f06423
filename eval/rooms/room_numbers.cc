// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/room_numbers.h"

#include <cmath>

#include "base/statistics.h"

namespace armature {
namespace {

constexpr double kRightAzimuth_deg = 15;

template <typename Function>
std::vector<double> OfFound(const EvaluatedRoom& room, const Function& value) {
  std::vector<double> values;
  for (const RoomObject& object : room.objects) {
    if (object.of.error) values.push_back(value(*object.of.error));
  }
  return values;
}

std::vector<double> OfObserved(const EvaluatedRoom& room) {
  std::vector<double> values;
  for (const RoomObject& object : room.objects) values.push_back(object.of.error ? 1 : 0);
  return values;
}

std::vector<double> IfAny(const std::optional<double>& value) {
  return value ? std::vector<double>{std::abs(*value)} : std::vector<double>{};
}

}  // namespace

std::vector<double> ValuesOf(const EvaluatedRoom& room, RoomQuantity quantity) {
  switch (quantity) {
    case RoomQuantity::kFound:
      return OfObserved(room);
    case RoomQuantity::kSpurious:
      return {static_cast<double>(room.spurious)};
    case RoomQuantity::kCentre:
      return OfFound(room, [](const ObjectError& error) { return error.centre_m; });
    case RoomQuantity::kScale:
      return IfAny(room.log_scale);
    case RoomQuantity::kAzimuth:
      return OfFound(room, [](const ObjectError& error) {
        return std::abs(error.orientation.azimuth_deg) <= kRightAzimuth_deg ? 1.0 : 0.0;
      });
    case RoomQuantity::kSize:
      return OfFound(room, [](const ObjectError& error) { return error.mean_size_m(); });
    case RoomQuantity::kCamera:
      return IfAny(room.ate_m);
  }
  return {};
}

const std::vector<RoomStatistic>& RoomStatistics() {
  using Q = RoomQuantity;
  using S = RoomSummary;
  static const std::vector<RoomStatistic> kAll{
      {Q::kFound, S::kMean, "found_share", "found [%]", 100, 0},
      {Q::kSpurious, S::kMean, "spurious_per_room", "spurious a room", 1, 2},
      {Q::kCentre, S::kMedian, "object_error_median_m", "centre median [m]", 1, 3},
      {Q::kCentre, S::kMean, "object_error_mean_m", "centre mean [m]", 1, 3},
      {Q::kCentre, S::kP90, "object_error_p90_m", "centre p90 [m]", 1, 3},
      {Q::kCentre, S::kWorst, "object_error_worst_m", "centre worst [m]", 1, 2},
      {Q::kScale, S::kMean, "log_scale_error_mean", "scale off [ln]", 1, 3},
      {Q::kAzimuth, S::kMean, "azimuth_within_15_deg_share", "azimuth in 15 deg [%]", 100, 0},
      {Q::kSize, S::kMean, "size_error_mean_m", "size [m]", 1, 3},
      {Q::kCamera, S::kMean, "ate_rmse_mean_m", "cameras [m]", 1, 3}};
  return kAll;
}

std::optional<double> NumberOf(const EvaluatedRoom& room, const RoomStatistic& statistic) {
  const std::vector<double> values = ValuesOf(room, statistic.quantity);
  if (values.empty()) return std::nullopt;
  switch (statistic.summary) {
    case RoomSummary::kMean:
      return ComputeStatistics(values)->mean;
    case RoomSummary::kMedian:
      return Median(values);
    case RoomSummary::kP90:
      return Quantile(values, 0.9);
    case RoomSummary::kWorst:
      return Quantile(values, 1);
  }
  return std::nullopt;
}

}  // namespace armature
