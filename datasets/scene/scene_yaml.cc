// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/scene_yaml.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "datasets/scene/scene.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"
#include "datasets/scene/solid.h"
#include "io/sequence.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

constexpr double kClearance = 0.1;  // metres

struct Obstacle {
  std::string name;
  OrientedBox box;
};

std::vector<Obstacle> Obstacles(const Scene& scene) {
  std::vector<Obstacle> obstacles;
  for (const SceneObject& object : scene.objects) {
    obstacles.push_back({object.id, {object.T_world_object, object.instance.size}});
  }
  for (size_t i = 0; i < scene.clutter.size(); ++i) {
    const ClutterPiece& piece = scene.clutter[i];
    obstacles.push_back({piece.id.empty() ? fmt::format("clutter[{}]", i) : piece.id,
                         MakeSolid(piece.mesh, piece.T_world_mesh).around});
  }
  return obstacles;
}

bool IsInside(const Room& room, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from_centre = point - Eigen::Vector3d(0, 0, 0.5 * room.size.z());
  return (from_centre.cwiseAbs() - 0.5 * room.size).maxCoeff() < -kClearance;
}

// What is wrong with the camera there, if anything.
std::string Collision(const Eigen::Vector3d& camera, const Room& room,
                      const std::vector<Obstacle>& obstacles) {
  if (!IsInside(room, camera)) return "outside of the room, or in a wall, floor or ceiling";
  for (const Obstacle& obstacle : obstacles) {
    if (IsNear(obstacle.box, camera, kClearance)) return "inside of or nearer than 0.1 m to " + obstacle.name;
  }
  return "";
}

// Throws InputError when the camera, anywhere on its path, is nearer than 0.1 m to an object, to a piece of
// clutter or to the room's walls, floor or ceiling, or outside of the room.
void CheckPath(const YamlMap& file, const Scene& scene) {
  const std::vector<Obstacle> obstacles = Obstacles(scene);
  const std::vector<Eigen::Isometry3d> poses = CameraPoses(scene.path, scene.frames, scene.seed);
  for (size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d camera = poses[i].translation();
    const std::string collision = Collision(camera, scene.room, obstacles);
    if (collision.empty()) continue;
    throw InputError(
        file.At("path", fmt::format("takes the camera at frame {} to [{:.2f}, {:.2f}, {:.2f}], {}; "
                                    "move the path or what is in its way",
                                    i, camera.x(), camera.y(), camera.z(), collision)));
  }
}

constexpr std::uint64_t kBetweenDraws = 1000;  // of seeds

void ReadHead(const YamlMap& map, int draw, Scene* scene) {
  int seed = 1;
  ReadFields(map,
             {Option("seed", &seed, "", 0), Option("fps", &scene->fps, "", 0.01, 1000),
              Option("frames", &scene->frames, "", 1, 100000),
              Option("light_grid", &scene->light_grid, "", 0.005, 1)},
             {"name", "about", "camera", "room", "objects", "clutter", "lamps", "path", "effects", "odometry",
              "detections"});
  if (map.Has("about")) scene->about = map.Text("about");
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
  scene.detections = ReadDetectorNoise(map);
  return scene;
}

}  // namespace armature
