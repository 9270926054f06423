// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "base/csv_fields.h"
#include "eval/rooms/room_factors.h"

namespace armature {
namespace {

// Empty where it is not known.
std::string RawNumber(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

std::string RawObject(const std::string& variant, const EvaluatedRoom& room, const RoomObject& object) {
  const std::optional<ObjectError>& error = object.of.error;
  const ObjectCircumstances& of = object.circumstances;
  std::string row =
      fmt::format("{},{},{},{},{},{},", CsvField(variant), CsvField(room.room), room.jitter,
                  CsvField(object.of.true_id), CsvField(object.of.category), StatusName(object.of.status));
  row += fmt::format("{},{},{},", error ? RawNumber(error->centre_m) : "",
                     error ? RawNumber(error->orientation.azimuth_deg) : "",
                     error ? RawNumber(error->mean_size_m()) : "");
  return row + fmt::format("{},{},{},{},{},{}\n", of.views, RawNumber(of.distance_m),
                           RawNumber(of.parallax_deg), RawNumber(of.hidden_share), of.was_whole ? 1 : 0,
                           RawNumber(of.size_deviation));
}

std::string RawRoom(const std::string& variant, const EvaluatedRoom& room) {
  const RoomCircumstances& of = room.circumstances;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", CsvField(variant), CsvField(room.room),
                     room.jitter, room.observed(), room.found(), room.spurious,
                     RawNumber(room.mean_error_m()), RawNumber(room.log_scale), RawNumber(room.ate_m),
                     of.images, of.objects, RawNumber(of.pitch_deg), RawNumber(of.camera_height_m),
                     RawNumber(of.path_m), CsvField(of.detections));
}

}  // namespace

std::string RawRoomObjectsCsv(const std::vector<RoomVariant>& variants) {
  std::string csv =
      "variant,room,jitter,object,category,status,centre_m,azimuth_deg,size_m,views,distance_m,parallax_deg,"
      "hidden_share,was_whole,size_deviation\n";
  for (const RoomVariant& variant : variants) {
    for (const EvaluatedRoom& room : variant.rooms) {
      for (const RoomObject& object : room.objects) csv += RawObject(variant.name, room, object);
    }
  }
  return csv;
}

std::string RawRoomsCsv(const std::vector<RoomVariant>& variants) {
  std::string csv =
      "variant,room,jitter,observed,found,spurious,centre_mean_m,log_scale,ate_rmse_m,images,objects,pitch_"
      "deg,"
      "camera_height_m,path_m,detections\n";
  for (const RoomVariant& variant : variants) {
    for (const EvaluatedRoom& room : variant.rooms) csv += RawRoom(variant.name, room);
  }
  return csv;
}

}  // namespace armature
