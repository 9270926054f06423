// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/scene_yaml.h"

#include <fmt/format.h>

#include "datasets/scene/path_check.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"
#include "io/sequence.h"

namespace armature {
namespace {

constexpr std::uint64_t kBetweenDraws = 1000;  // of seeds

void ReadHead(const YamlMap& map, int draw, Scene* scene) {
  int seed = 1;
  ReadFields(
      map,
      {Option("name", &scene->name, ""), Option("about", &scene->about, ""), Option("seed", &seed, "", 0),
       Option("fps", &scene->fps, "", 0.01, 1000), Option("frames", &scene->frames, "", 1, 100000)},
      {"camera", "room", "objects", "clutter", "lamps", "path", "effects", "odometry", "detections"});
  scene->name = NameDraw(ReadName(map, "name"), draw);
  scene->seed = static_cast<std::uint64_t>(seed) + kBetweenDraws * static_cast<std::uint64_t>(draw - 1);
}

}  // namespace

Scene ReadScene(const std::filesystem::path& file, const std::vector<CadInstance>& collection, int draw) {
  const YamlMap map = YamlMap::Load(file);
  Scene scene;
  ReadHead(map, draw, &scene);
  scene.camera = ReadCamera(map);
  scene.room = ReadRoom(map);
  scene.lamps = ReadLamps(map, scene.room);
  scene.objects = ReadObjects(map, scene, collection);
  scene.clutter = ReadClutter(map, scene);
  scene.path = ReadPath(map);
  CheckPath(map, scene);
  scene.effects = ReadEffects(map);
  scene.odometry = ReadOdometryNoise(map);
  scene.detections = ReadDetectionNoise(map);
  return scene;
}

}  // namespace armature
