// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/error_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/statistics.h"
#include "eval/statistics/room_difference.h"

namespace armature {
namespace {

const std::string kAllSettings = "all";

// What `room` made of it; none: missed.
std::optional<double> ErrorOf(const EvaluatedRoom& room, const RoomObject& object) {
  const auto same = std::find_if(room.objects.begin(), room.objects.end(), [&](const RoomObject& other) {
    return other.of.true_id == object.of.true_id;
  });
  if (same == room.objects.end() || !same->of.error) return std::nullopt;
  return same->of.error->centre_m;
}

// Of one variant, over rooms of one setting.
struct BudgetSums {
  long objects = 0;
  int spurious = 0;
  std::vector<double> errors_m;                        // of what was found
  std::vector<double> log_scales;                      // absolute
  std::vector<std::pair<double, double>> room_errors;  // the variant's, the first one's
};

BudgetSums SumUp(const RoomVariant& first, const RoomVariant& variant, const std::string& setting,
                 double gate_m) {
  BudgetSums sums;
  for (const EvaluatedRoom& as_it_is : first.rooms) {
    const EvaluatedRoom* room = FindRoom(variant, as_it_is.room);
    if (!room || (setting != kAllSettings && as_it_is.circumstances.detections != setting)) continue;
    for (const RoomObject& object : as_it_is.objects) {
      ++sums.objects;
      if (const auto error_m = ErrorOf(*room, object)) sums.errors_m.push_back(*error_m);
    }
    sums.spurious += room->spurious;
    if (room->log_scale) sums.log_scales.push_back(std::abs(*room->log_scale));
    sums.room_errors.emplace_back(ErrorOfSameObjects(as_it_is, *room, gate_m),
                                  ErrorOfSameObjects(as_it_is, as_it_is, gate_m));
  }
  return sums;
}

Cell GainCell(const RoomDifference& difference, bool is_first) {
  if (is_first) return NoCell();
  return TextCell(fmt::format("{:.3f} [{:.3f}, {:.3f}]{}", difference.mean, difference.interval.low,
                              difference.interval.high,
                              difference.mark == DifferenceMark::kTooFew ? " (too few rooms)" : ""));
}

std::optional<double> QuantileIfAny(const std::vector<double>& values, double share) {
  return values.empty() ? std::nullopt : std::optional(Quantile(values, share));
}

void AddBudgetRows(const std::vector<RoomVariant>& variants, const std::string& setting, double gate_m,
                   Table& table) {
  for (const RoomVariant& variant : variants) {
    const BudgetSums sums = SumUp(variants.front(), variant, setting, gate_m);
    const auto difference = CompareRooms(sums.room_errors);
    if (!difference) continue;
    const double rooms = static_cast<double>(difference->rooms);
    table.rows.push_back(
        {TextCell(setting), TextCell(variant.name), CountCell(static_cast<long>(difference->rooms)),
         PercentCell(static_cast<double>(sums.errors_m.size()), static_cast<double>(sums.objects)),
         NumberCell(sums.spurious / rooms, 2), NumberCell(QuantileIfAny(sums.errors_m, 0.5), 3),
         NumberCell(QuantileIfAny(sums.errors_m, 0.9), 3), NumberCell(QuantileIfAny(sums.log_scales, 0.5), 3),
         NumberCell(difference->mean_a, 3), GainCell(*difference, &variant == &variants.front())});
  }
}

}  // namespace

double ErrorOfSameObjects(const EvaluatedRoom& as_it_is, const EvaluatedRoom& room, double gate_m) {
  double sum = gate_m * room.spurious;
  for (const RoomObject& object : as_it_is.objects) sum += ErrorOf(room, object).value_or(gate_m);
  return sum / std::max(as_it_is.observed(), 1);
}

Table ErrorBudgetTable(const std::vector<RoomVariant>& variants, double gate_m) {
  const std::string first = variants.front().name;
  Table table{
      .title = "Error budget: what the error of " + first + " is made of",
      .columns = {"detections", "truth given", "rooms", "found [%]", "spurious a room", "centre median [m]",
                  "centre p90 [m]", "scale off, median [ln]", "error an object [m]", "gain [m]"},
      .rows = {},
      .notes = {},
      .name = "error_budget"};
  std::set<std::string> settings;
  for (const EvaluatedRoom& room : variants.front().rooms) settings.insert(room.circumstances.detections);
  AddBudgetRows(variants, kAllSettings, gate_m, table);
  if (settings.size() > 1) {
    settings.erase("");
    for (const std::string& setting : settings) AddBudgetRows(variants, setting, gate_m, table);
  }
  table.notes = {
      fmt::format("error: mean over the rooms' objects that could be seen in {}, where a missed or spurious "
                  "one counts {:g} m; an object whose detections were left out counts as missed. found, "
                  "centre: of the same objects.",
                  first, gate_m),
      fmt::format(
          "gain: mean over rooms of how much lower a room's error is than that of {}, [from, to]: its "
          "95 % interval (bootstrap over rooms). Gains overlap, and do not add up.",
          first),
      "detections: the setting that made them, as the room's scene.yaml has it."};
  return table;
}

}  // namespace armature
