// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/room_stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/statistics.h"

namespace armature {
namespace {

// The name of the variant that this one repeats with that jitter; empty: none.
std::string FindRepeated(const RoomVariant& variant) {
  if (variant.rooms.empty() || variant.rooms.front().jitter == 0) return "";
  const std::string ending = fmt::format("-{}", variant.rooms.front().jitter);
  if (!variant.name.ends_with(ending)) return "";
  return variant.name.substr(0, variant.name.size() - ending.size());
}

// Of one room in all repeats that have it.
struct RoomRepeats {
  std::vector<double> errors, log_scales;
  std::set<int> found, spurious;
  size_t repeats = 0;
};

RoomRepeats CollectRepeats(const RepeatedVariant& variant, const std::string& room) {
  RoomRepeats all;
  for (const RoomVariant& repeat : variant.repeats) {
    const EvaluatedRoom* of = FindRoom(repeat, room);
    if (of == nullptr) continue;
    ++all.repeats;
    if (const auto error = of->mean_error_m()) all.errors.push_back(*error);
    if (of->log_scale) all.log_scales.push_back(*of->log_scale);
    all.found.insert(of->found());
    all.spurious.insert(of->spurious);
  }
  return all;
}

void AddDeviation(const std::vector<double>& values, std::vector<double>& deviations) {
  if (values.size() >= 2) deviations.push_back(ComputeStatistics(values)->deviation);
}

std::vector<Cell> StabilityRow(const RepeatedVariant& variant) {
  std::vector<double> errors, scales;
  long rooms = 0, found_changes = 0, spurious_changes = 0;
  for (const EvaluatedRoom& room : variant.repeats.front().rooms) {
    const RoomRepeats repeats = CollectRepeats(variant, room.room);
    if (repeats.repeats < 2) continue;
    ++rooms;
    AddDeviation(repeats.errors, errors);
    AddDeviation(repeats.log_scales, scales);
    found_changes += repeats.found.size() > 1 ? 1 : 0;
    spurious_changes += repeats.spurious.size() > 1 ? 1 : 0;
  }
  return {TextCell(variant.name),
          CountCell(rooms),
          CountCell(static_cast<long>(variant.repeats.size())),
          NumberCell(Quantile(errors, 0.5), 4),
          NumberCell(Quantile(errors, 1), 4),
          NumberCell(Quantile(scales, 0.5), 4),
          NumberCell(Quantile(scales, 1), 4),
          PercentCell(static_cast<double>(found_changes), static_cast<double>(rooms)),
          PercentCell(static_cast<double>(spurious_changes), static_cast<double>(rooms))};
}

}  // namespace

std::vector<RepeatedVariant> TakeRepeats(std::vector<RoomVariant>& variants) {
  std::vector<RepeatedVariant> repeated;
  for (const RoomVariant& variant : variants) {
    if (FindRepeated(variant).empty()) repeated.push_back({variant.name, {variant}});
  }
  const auto find = [&](const std::string& name) {
    return std::find_if(repeated.begin(), repeated.end(),
                        [&](const RepeatedVariant& known) { return known.name == name; });
  };
  std::erase_if(variants, [&](const RoomVariant& variant) {
    const auto of = find(FindRepeated(variant));
    if (of == repeated.end()) return false;
    of->repeats.push_back(variant);
    return true;
  });
  std::erase_if(repeated, [](const RepeatedVariant& variant) { return variant.repeats.size() < 2; });
  return repeated;
}

Table StabilityTable(const std::vector<RepeatedVariant>& variants) {
  Table table{
      .title = "Stability: the same rooms with changes that must not matter",
      .columns = {"variant", "rooms", "runs a room", "centre: median spread [m]", "greatest [m]",
                  "ln scale: median spread", "greatest", "found changes [%]", "spurious changes [%]"},
      .rows = {},
      .notes =
          {"Each room was run as it is and with the ends of lines moved by 0.1 pixel and the sides of "
           "boxes by 0.1 % (run --jitter). spread: standard deviation (n - 1) over the runs of a room, of "
           "the mean centre error of its found objects and of the logarithm of the scale; median and "
           "greatest over rooms. changes: rooms whose runs do not all have the same number."},
      .name = "stability"};
  for (const RepeatedVariant& variant : variants) table.rows.push_back(StabilityRow(variant));
  return table;
}

}  // namespace armature
