// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rooms/room_text.h"

#include <fmt/format.h>

namespace armature {
namespace {

const char* TextureName(Texture texture) {
  switch (texture) {
    case Texture::kWood:
      return "wood";
    case Texture::kFabric:
      return "fabric";
    case Texture::kCarpet:
      return "carpet";
    case Texture::kTiles:
      return "tiles";
    case Texture::kBoards:
      return "boards";
    default:
      return "plain";
  }
}

std::string Triple(const Eigen::Vector3d& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

std::string Pair(const Eigen::Vector2d& v) { return fmt::format("[{}, {}]", v.x(), v.y()); }

std::string MaterialText(const Material& material) {
  return fmt::format("{{texture: {}, colour: {}, second: {}, scale: {}, gloss: {}}}",
                     TextureName(material.texture), Triple(material.colour), Triple(material.second),
                     material.scale, material.gloss);
}

std::string HeadText(const Scene& scene) {
  const Camera& camera = scene.camera;
  std::string text = fmt::format("name: {}\n", scene.name);
  if (!scene.about.empty()) text += fmt::format("about: {}\n", scene.about);
  text += fmt::format("seed: {}\nfps: {}\nframes: {}\nlight_grid: {}\n", scene.seed, scene.fps, scene.frames,
                      scene.light_grid);
  text += fmt::format("camera: {{width: {}, height: {}, fx: {}, fy: {}}}\n", camera.width, camera.height,
                      camera.fx, camera.fy);
  return text;
}

std::string ShellText(const Scene& scene) {
  const Room& room = scene.room;
  std::string text = fmt::format(
      "room:\n  size: {}\n  floor: {}\n  walls: {}\n  pictures: {}\n  clutter: {}\n  table_clutter: "
      "{}\nlamps:\n",
      Triple(room.size), MaterialText(room.floor), MaterialText(room.walls), room.pictures, room.clutter,
      room.table_clutter);
  for (const Lamp& lamp : scene.lamps)
    text += fmt::format("  - {{position: {}, size: {}, colour: {}, power: {}}}\n", Triple(lamp.centre),
                        Pair(lamp.size), Triple(lamp.colour), lamp.power);
  return text;
}

std::string PlaceText(const Placement& at) {
  const std::string on = at.on.empty() ? "" : fmt::format("on: {}, ", at.on);
  return fmt::format("{}position: {}, yaw_deg: {}", on, Pair(at.position), at.yaw_deg);
}

std::string ThingsText(const DrawnRoom& room) {
  std::string text = room.scene.objects.empty() ? "" : "objects:\n";
  for (size_t i = 0; i < room.scene.objects.size(); ++i) {
    const SceneObject& object = room.scene.objects[i];
    const CadInstance& instance = object.instance;
    const std::string lid = instance.lid_deg ? fmt::format("lid_deg: {}, ", *instance.lid_deg) : "";
    text += fmt::format("  - {{id: {}, category: {}, collection: {}, instance: {}, {}size: {}, {}}}\n",
                        object.id, instance.category, instance.collection, instance.id, lid,
                        Triple(instance.size), PlaceText(room.objects[i]));
  }
  text += room.scene.clutter.empty() ? "" : "clutter:\n";
  for (size_t i = 0; i < room.scene.clutter.size(); ++i) {
    const ClutterPiece& piece = room.scene.clutter[i];
    text += fmt::format("  - {{id: {}, shape: {}, size: {}, {}}}\n", piece.id, piece.shape,
                        Triple(room.clutter_sizes[i]), PlaceText(room.clutter[i]));
  }
  return text;
}

std::string PathText(const CameraPath& path) {
  std::string text = fmt::format("  height: {}\n  pitch_deg: {}\n  sway_deg: {}\n", path.height,
                                 path.pitch_deg, path.sway_deg);
  if (path.kind == CameraPath::Kind::kTurn)
    return fmt::format(
        "path:\n  kind: turn\n{}  centre: {}\n  overlap: {}\n  start_deg: {}\n  clockwise: {}\n", text,
        Pair(path.centre), path.overlap, path.start_deg, path.clockwise);
  text += fmt::format("  sway: {}\n", path.sway);
  if (path.kind == CameraPath::Kind::kLoop)
    return fmt::format(
        "path:\n  kind: loop\n{}  centre: {}\n  overlap: {}\n  length: {}\n  width: {}\n  "
        "heading_offset_deg: {}\n  clockwise: {}\n",
        text, Pair(path.centre), path.overlap, path.length, path.width, path.heading_offset_deg,
        path.clockwise);
  text = "path:\n  kind: keyframes\n" + text + "  keyframes:\n";
  for (const CameraPath::Keyframe& key : path.keyframes) {
    text += fmt::format("    - {{position: {}, heading_deg: {}, height: {}, pitch_deg: {}, roll_deg: {}}}\n",
                        Pair(key.position), key.heading_deg, *key.height, *key.pitch_deg, key.roll_deg);
  }
  return text;
}

}  // namespace

std::string RoomText(const DrawnRoom& room) {
  return HeadText(room.scene) + ShellText(room.scene) + ThingsText(room) + PathText(room.scene.path) +
         room.sections;
}

}  // namespace armature
