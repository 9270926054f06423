// SPDX-License-Identifier: BSD-3-Clause
// Room and lamps of a scene file.
#include <fmt/format.h>

#include "base/enum_names.h"
#include "base/errors.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"

namespace armature {

// Those that walls and floors may have.
template <>
struct EnumNames<Texture> {
  static constexpr NamedValue<Texture> kTable[] = {
      {Texture::kPlain, "plain"},   {Texture::kWood, "wood"},   {Texture::kFabric, "fabric"},
      {Texture::kCarpet, "carpet"}, {Texture::kTiles, "tiles"}, {Texture::kBoards, "boards"}};
};

namespace {

void ReadMaterial(const YamlMap& map, Material* material) {
  ReadFields(map,
             {Option("texture", &material->texture, ""), Option("scale", &material->scale, "", 1e-3, 100),
              Option("gloss", &material->gloss, "", 0, 1)},
             {"colour", "second"});
  if (map.Has("colour")) material->colour = ReadColour(map, "colour");
  // Joints and grain a little darker than the rest.
  material->second = map.Has("second") ? ReadColour(map, "second") : Colour(0.75 * material->colour);
}

Material DefaultFloor() { return {Texture::kBoards, {0.62, 0.47, 0.32}, {0.35, 0.25, 0.16}, 0.14, 0.2, 0}; }

Material DefaultWalls() { return {Texture::kPlain, {0.86, 0.84, 0.79}, {0.8, 0.78, 0.73}, 0.5, 0, 0}; }

std::vector<Lamp> DefaultLamps(const Room& room) {
  std::vector<Lamp> lamps(2);
  for (int i = 0; i < 2; ++i) {
    lamps[static_cast<size_t>(i)].centre = {(i - 0.5) * 0.5 * room.size.x(), 0, room.size.z() - 0.1};
  }
  return lamps;
}

Lamp ReadLamp(const YamlMap& map, const Room& room) {
  Lamp lamp;
  ReadFields(map, {Option("power", &lamp.power, "", 1e-3, 100)}, {"position", "size", "colour"});
  lamp.centre = ReadTriple(map, "position");
  if (map.Has("colour")) lamp.colour = ReadColour(map, "colour");
  if (map.Has("size")) lamp.size = ReadPair(map, "size");
  if (lamp.size.minCoeff() <= 0) {
    throw InputError(map.At("size", fmt::format("is [{}, {}]; write lengths greater than 0, in metres",
                                                lamp.size.x(), lamp.size.y())));
  }
  const Eigen::Vector2d beyond =
      lamp.centre.head<2>().cwiseAbs() + 0.5 * lamp.size - 0.5 * room.size.head<2>();
  if (beyond.maxCoeff() > 0 || lamp.centre.z() <= 0 || lamp.centre.z() >= room.size.z()) {
    throw InputError(map.At(
        "position", fmt::format("is outside of the room, which reaches from [{}, {}, 0] to [{}, {}, {}]; "
                                "move the lamp inside",
                                -0.5 * room.size.x(), -0.5 * room.size.y(), 0.5 * room.size.x(),
                                0.5 * room.size.y(), room.size.z())));
  }
  return lamp;
}

}  // namespace

Room ReadRoom(const YamlMap& file) {
  const YamlMap map = file.MapOrEmpty("room");
  Room room;
  room.floor = DefaultFloor();
  room.walls = DefaultWalls();
  if (map.Has("size")) room.size = ReadSize(map, "size");
  ReadFields(
      map,
      {Option("skirting", &room.skirting, "", 0, 0.5), Option("pictures", &room.pictures, "", 0, 100),
       Option("clutter", &room.clutter, "", 0, 200), Option("table_clutter", &room.table_clutter, "", 0, 50)},
      {"size", "floor", "walls"});
  if (map.Has("floor")) ReadMaterial(map.Map("floor"), &room.floor);
  if (map.Has("walls")) ReadMaterial(map.Map("walls"), &room.walls);
  return room;
}

std::vector<Lamp> ReadLamps(const YamlMap& file, const Room& room) {
  if (!file.Has("lamps")) return DefaultLamps(room);
  std::vector<Lamp> lamps;
  for (const YamlMap& map : file.Maps("lamps")) lamps.push_back(ReadLamp(map, room));
  if (lamps.empty()) throw InputError(file.At("lamps", "is empty; give a lamp, or leave the key out"));
  return lamps;
}

}  // namespace armature
