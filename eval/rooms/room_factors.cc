// SPDX-License-Identifier: BSD-3-Clause
#include "eval/rooms/room_factors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "base/statistics.h"
#include "eval/statistics/rank_correlation.h"

namespace armature {
namespace {

struct FactorOfObject {
  const char* name;
  int digits;
  std::optional<double> (*value)(const ObjectCircumstances&);
};

struct FactorOfRoom {
  const char* name;
  int digits;
  std::optional<double> (*value)(const EvaluatedRoom&);
};

using Objects = ObjectCircumstances;
constexpr std::array kObjectFactors{
    FactorOfObject{"distance [m]", 2, [](const Objects& of) { return of.distance_m; }},
    FactorOfObject{"views", 0, [](const Objects& of) { return std::optional<double>(of.views); }},
    FactorOfObject{"parallax [deg]", 1, [](const Objects& of) { return of.parallax_deg; }},
    FactorOfObject{"hidden share", 2, [](const Objects& of) { return of.hidden_share; }},
    FactorOfObject{"ever whole in the image", 0,
                   [](const Objects& of) { return std::optional<double>(of.was_whole ? 1 : 0); }},
    FactorOfObject{"size deviation [ln]", 2,
                   [](const Objects& of) { return std::optional<double>(of.size_deviation); }}};

constexpr std::array kRoomFactors{
    FactorOfRoom{"camera pitch [deg]", 1,
                 [](const EvaluatedRoom& room) { return room.circumstances.pitch_deg; }},
    FactorOfRoom{"camera height [m]", 2,
                 [](const EvaluatedRoom& room) { return room.circumstances.camera_height_m; }},
    FactorOfRoom{"camera path [m]", 2,
                 [](const EvaluatedRoom& room) { return std::optional<double>(room.circumstances.path_m); }},
    FactorOfRoom{"images", 0,
                 [](const EvaluatedRoom& room) {
                   return std::optional<double>(static_cast<double>(room.circumstances.images));
                 }},
    FactorOfRoom{"objects", 0,
                 [](const EvaluatedRoom& room) {
                   return std::optional<double>(static_cast<double>(room.circumstances.objects));
                 }},
    FactorOfRoom{"scale off [ln]", 3, [](const EvaluatedRoom& room) {
                   return room.log_scale ? std::optional(std::abs(*room.log_scale)) : std::nullopt;
                 }}};

// Errors of what was found, and for each object or room the share that was missed.
struct FactorPairs {
  std::vector<PairInRoom> errors, missed;
};

FactorPairs PairObjects(const RoomVariant& variant, const FactorOfObject& factor) {
  FactorPairs pairs;
  for (size_t i = 0; i < variant.rooms.size(); ++i) {
    for (const RoomObject& object : variant.rooms[i].objects) {
      const auto x = factor.value(object.circumstances);
      if (!x) continue;
      pairs.missed.push_back({*x, object.of.error ? 0.0 : 1.0, i});
      if (object.of.error) pairs.errors.push_back({*x, object.of.error->centre_m, i});
    }
  }
  return pairs;
}

FactorPairs PairRooms(const RoomVariant& variant, const FactorOfRoom& factor) {
  FactorPairs pairs;
  for (size_t i = 0; i < variant.rooms.size(); ++i) {
    const EvaluatedRoom& room = variant.rooms[i];
    const auto x = factor.value(room);
    if (!x || room.observed() == 0) continue;
    pairs.missed.push_back({*x, 1 - static_cast<double>(room.found()) / room.observed(), i});
    if (const auto error = room.mean_error_m()) pairs.errors.push_back({*x, *error, i});
  }
  return pairs;
}

// What is the same everywhere goes with nothing.
bool Varies(const std::vector<PairInRoom>& pairs) {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const PairInRoom& pair) { return pair.x != pairs.front().x; });
}

std::vector<Cell> FactorRow(const std::string& name, const std::string& unit, int digits,
                            const FactorPairs& pairs, const RoomBootstrap& bootstrap) {
  const RankCorrelation correlation(pairs.errors);
  const auto interval = bootstrap.Of([&](const RoomCounts& counts) { return correlation.Of(counts); });
  std::vector<Cell> row{TextCell(name), TextCell(unit), CountCell(static_cast<long>(pairs.errors.size())),
                        NumberCell(correlation.Of(bootstrap.Once()), 2)};
  row.push_back(interval ? NumberCell(interval->low, 2) : NoCell());
  row.push_back(interval ? NumberCell(interval->high, 2) : NoCell());
  const Thirds missed = SplitByThirds(pairs.missed).value();
  std::array<std::vector<double>, 3> errors;
  for (const PairInRoom& pair : pairs.errors)
    errors[pair.x <= missed.bounds[0] ? 0 : pair.x <= missed.bounds[1] ? 1 : 2].push_back(pair.y);
  for (const double bound : missed.bounds) row.push_back(NumberCell(bound, digits));
  for (const auto& third : errors) row.push_back(third.empty() ? NoCell() : NumberCell(Median(third), 3));
  for (const auto& mean : missed.means) row.push_back(mean ? NumberCell(100 * *mean, 0) : NoCell());
  return row;
}

std::string OrUnknown(const std::string& text) { return text.empty() ? "unknown" : text; }

// Objects of one kind, and the rooms that are.
struct Group {
  std::vector<double> errors;
  long objects = 0;
  long rooms = 0, spurious = 0;
  std::vector<double> log_scales;  // absolute
};

std::vector<Cell> GroupRow(const std::string& kind, const std::string& name, const Group& group) {
  std::vector<Cell> row{
      TextCell(kind),
      TextCell(name),
      CountCell(group.objects),
      PercentCell(static_cast<double>(group.errors.size()), static_cast<double>(group.objects)),
      NumberCell(Quantile(group.errors, 0.5), 3),
      NumberCell(Quantile(group.errors, 0.9), 3)};
  if (group.rooms == 0) {
    row.insert(row.end(), {NoCell(), NoCell(), NoCell()});
    return row;
  }
  row.push_back(CountCell(group.rooms));
  row.push_back(NumberCell(static_cast<double>(group.spurious) / static_cast<double>(group.rooms), 2));
  row.push_back(NumberCell(Quantile(group.log_scales, 0.5), 3));
  return row;
}

void AddObject(const RoomObject& object, Group& group) {
  ++group.objects;
  if (object.of.error) group.errors.push_back(object.of.error->centre_m);
}

void AddRoom(const EvaluatedRoom& room, Group& group) {
  ++group.rooms;
  group.spurious += room.spurious;
  if (room.log_scale) group.log_scales.push_back(std::abs(*room.log_scale));
  for (const RoomObject& object : room.objects) AddObject(object, group);
}

}  // namespace

Table RoomFactorTable(const RoomVariant& variant) {
  Table table{.title = "What goes with errors: " + variant.name,
              .columns = {"circumstance", "of", "n", "rank correlation", "from", "to", "first third up to",
                          "second up to", "median of first [m]", "of second [m]", "of last [m]",
                          "missed in first [%]", "in second [%]", "in last [%]"},
              .rows = {},
              .notes = {},
              .name = "room_factors"};
  const RoomBootstrap bootstrap(variant.rooms.size());
  const auto add = [&](const char* name, const char* unit, int digits, const FactorPairs& pairs) {
    if (Varies(pairs.missed)) table.rows.push_back(FactorRow(name, unit, digits, pairs, bootstrap));
  };
  for (const FactorOfObject& factor : kObjectFactors)
    add(factor.name, "objects", factor.digits, PairObjects(variant, factor));
  for (const FactorOfRoom& factor : kRoomFactors)
    add(factor.name, "rooms", factor.digits, PairRooms(variant, factor));
  table.notes = {
      "rank correlation: Spearman's, of the circumstance with the centre's error of the found objects, or "
      "with the "
      "mean error of the rooms; from, to: 95 % interval (bootstrap over rooms). Thirds are of all objects "
      "that could "
      "be seen; equal ones stay together, so that thirds may differ and one be empty; of yes (1) and no (0), "
      "no is the "
      "first. It says what goes together, not why.",
      "distance: median over the views; views: images in which it was detected; parallax: between the two "
      "rays that "
      "are furthest apart; hidden share: of its edges in the views; ever whole: its box inside some view's "
      "image; "
      "size deviation: from the category's mean, of the natural logarithm, mean over the axes; camera pitch: "
      "median, "
      "below the horizon."};
  return table;
}

Table RoomGroupTable(const RoomVariant& variant) {
  Table table{
      .title = "Errors by kind: " + variant.name,
      .columns = {"kind", "name", "objects", "found [%]", "centre median [m]", "centre p90 [m]", "rooms",
                  "spurious a room", "scale off, median [ln]"},
      .rows = {},
      .notes = {"detections: the setting that made them; path: how the camera moved; both as the room's "
                "scene.yaml has them; given: by run --detections."},
      .name = "room_groups"};
  std::map<std::string, Group> categories, settings, paths;
  for (const EvaluatedRoom& room : variant.rooms) {
    for (const RoomObject& object : room.objects) AddObject(object, categories[object.of.category]);
    AddRoom(room, settings[OrUnknown(room.circumstances.detections)]);
    AddRoom(room, paths[OrUnknown(room.circumstances.path)]);
  }
  for (const auto& [name, group] : categories) table.rows.push_back(GroupRow("category", name, group));
  for (const auto& [name, group] : settings) table.rows.push_back(GroupRow("detections", name, group));
  for (const auto& [name, group] : paths) table.rows.push_back(GroupRow("path", name, group));
  return table;
}

}  // namespace armature
