// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/worst_rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eval/rooms/error_budget.h"

namespace armature {
namespace {

// From where on something is told of.
constexpr double kWrongScale = 0.05;  // |ln|
constexpr double kFarOff_m = 0.2;     // of a centre
constexpr double kTurned_deg = 30;    // of an azimuth
constexpr double kWrongCameras_m = 0.1;
constexpr size_t kNamedObjects = 3;

// The furthest first.
std::vector<std::string> FarObjects(const EvaluatedRoom& room) {
  std::vector<std::pair<double, std::string>> far;
  for (const RoomObject& object : room.objects) {
    const auto& error = object.of.error;
    if (error && error->centre_m >= kFarOff_m) far.emplace_back(error->centre_m, object.of.true_id);
  }
  std::sort(far.rbegin(), far.rend());
  std::vector<std::string> texts;
  for (const auto& [error_m, id] : far) {
    if (texts.size() == kNamedObjects) {
      texts.push_back(fmt::format("{} more", far.size() - kNamedObjects));
      break;
    }
    texts.push_back(fmt::format("{} {:.2f} m off", id, error_m));
  }
  return texts;
}

}  // namespace

std::vector<WorstRoomRecord> FindWorstRooms(const RoomVariant& variant, double gate_m) {
  std::vector<WorstRoomRecord> worst;
  for (const EvaluatedRoom& room : variant.rooms)
    worst.push_back({variant.name, room.room, room.folder.string(), ErrorOfSameObjects(room, room, gate_m)});
  std::stable_sort(worst.begin(), worst.end(),
                   [](const WorstRoomRecord& a, const WorstRoomRecord& b) { return a.error_m > b.error_m; });
  if (worst.size() > kWorstRooms) worst.resize(kWorstRooms);
  return worst;
}

std::string DescribeFaults(const EvaluatedRoom& room) {
  std::vector<std::string> faults;
  if (const int missed = room.observed() - room.found(); missed > 0)
    faults.push_back(fmt::format("{} of {} missed", missed, room.observed()));
  if (room.spurious > 0) faults.push_back(fmt::format("{} spurious", room.spurious));
  if (room.log_scale && std::abs(*room.log_scale) >= kWrongScale)
    faults.push_back(fmt::format("scale {:.2f} times", std::exp(*room.log_scale)));
  if (room.ate_m && *room.ate_m >= kWrongCameras_m)
    faults.push_back(fmt::format("cameras {:.2f} m off", *room.ate_m));
  for (const std::string& object : FarObjects(room)) faults.push_back(object);
  const auto turned = std::count_if(room.objects.begin(), room.objects.end(), [](const RoomObject& object) {
    return object.of.error && std::abs(object.of.error->orientation.azimuth_deg) >= kTurned_deg;
  });
  if (turned > 0) faults.push_back(fmt::format("{} turned by more than {:.0f} deg", turned, kTurned_deg));
  return fmt::format("{}", fmt::join(faults, ", "));
}

Table WorstRoomTable(const RoomVariant& variant, double gate_m) {
  Table table{
      .title = "The worst rooms: " + variant.name,
      .columns = {"room", "error [m]", "found", "observed", "centre mean [m]", "what is wrong"},
      .rows = {},
      .notes = {fmt::format("error: mean over the objects that could be seen, where a missed or spurious one "
                            "counts {:g} m.",
                            gate_m)},
      .name = "worst_rooms"};
  for (const WorstRoomRecord& record : FindWorstRooms(variant, gate_m)) {
    const EvaluatedRoom& room = *FindRoom(variant, record.sequence);
    table.rows.push_back({TextCell(record.sequence), NumberCell(record.error_m, 3), CountCell(room.found()),
                          CountCell(room.observed()), NumberCell(room.mean_error_m(), 3),
                          TextCell(DescribeFaults(room))});
  }
  return table;
}

}  // namespace armature
