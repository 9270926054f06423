// SPDX-License-Identifier: BSD-3-Clause
// The camera's path in a scene file.
#include <fmt/format.h>

#include "base/errors.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"

namespace armature {

enum class PathKind { kLoop, kTurn, kKeyframes };

template <>
struct EnumNames<PathKind> {
  static constexpr NamedValue<PathKind> kTable[] = {
      {PathKind::kLoop, "loop"}, {PathKind::kTurn, "turn"}, {PathKind::kKeyframes, "keyframes"}};
};

namespace {

using Fields = std::vector<OptionEntry>;

Fields Joined(Fields fields, const Fields& more) {
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

void ReadLoop(const YamlMap& map, const Fields& common, CameraPath* path) {
  path->kind = CameraPath::Kind::kLoop;
  ReadFields(
      map,
      Joined(common,
             {Option("length", &path->length, "", 0.01, 1000), Option("width", &path->width, "", 0.01, 1000),
              Option("overlap", &path->overlap, "", 0, 10),
              Option("heading_offset_deg", &path->heading_offset_deg, "", -180, 180),
              Option("clockwise", &path->clockwise, ""), Option("sway", &path->sway, "", 0, 1)}),
      {"kind", "centre"});
  if (map.Has("centre")) path->centre = ReadPair(map, "centre");
  if (path->width > path->length) {
    throw InputError(map.At("width", fmt::format("{} is greater than the length {}; the longer side is the "
                                                 "length",
                                                 path->width, path->length)));
  }
}

void ReadTurn(const YamlMap& map, const Fields& common, CameraPath* path) {
  path->kind = CameraPath::Kind::kTurn;
  ReadFields(map,
             Joined(common, {Option("overlap", &path->overlap, "", 0, 10),
                             Option("start_deg", &path->start_deg, "", -360, 360),
                             Option("clockwise", &path->clockwise, "")}),
             {"kind", "centre"});
  if (map.Has("centre")) path->centre = ReadPair(map, "centre");
}

void ReadKeyframes(const YamlMap& map, const Fields& common, CameraPath* path) {
  path->kind = CameraPath::Kind::kKeyframes;
  ReadFields(map, Joined(common, {Option("sway", &path->sway, "", 0, 1)}), {"kind", "keyframes"});
  for (const YamlMap& item : map.Maps("keyframes")) {
    CameraPath::Keyframe key;
    double height = path->height, pitch_deg = path->pitch_deg;
    ReadFields(
        item,
        {Option("heading_deg", &key.heading_deg, "", -720, 720), Option("height", &height, "", 0, 1000),
         Option("pitch_deg", &pitch_deg, "", -89, 89), Option("roll_deg", &key.roll_deg, "", -180, 180)},
        {"position"});
    key.position = ReadPair(item, "position");
    if (item.Has("height")) key.height = height;
    if (item.Has("pitch_deg")) key.pitch_deg = pitch_deg;
    path->keyframes.push_back(key);
  }
  if (path->keyframes.size() < 2) throw InputError(map.At("keyframes", "needs two or more poses; add some"));
}

}  // namespace

CameraPath ReadPath(const YamlMap& file) {
  const YamlMap map = file.MapOrEmpty("path");
  CameraPath path;
  PathKind kind = PathKind::kLoop;
  ReadField(map, Option("kind", &kind, ""));
  const Fields common{Option("height", &path.height, "", 0, 1000),
                      Option("pitch_deg", &path.pitch_deg, "", -89, 89),
                      Option("sway_deg", &path.sway_deg, "", 0, 45)};
  if (kind == PathKind::kLoop) ReadLoop(map, common, &path);
  if (kind == PathKind::kTurn) ReadTurn(map, common, &path);
  if (kind == PathKind::kKeyframes) ReadKeyframes(map, common, &path);
  return path;
}

}  // namespace armature
