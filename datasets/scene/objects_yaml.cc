// SPDX-License-Identifier: BSD-3-Clause
// Objects and clutter of a scene file.
#include <fmt/format.h>

#include "base/errors.h"
#include "base/text.h"
#include "datasets/scene/clutter.h"
#include "datasets/scene/instance_yaml.h"
#include "datasets/scene/place_yaml.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"
#include "geometry/random.h"

namespace armature {
namespace {

// Of the i-th thing in a list.
Random MakeRandom(std::uint64_t seed, size_t i) { return Random(1000003 * seed + i); }

void CheckIsNew(const YamlMap& map, const std::string& id, const std::vector<SceneObject>& objects) {
  for (const SceneObject& object : objects) {
    if (object.id != id) continue;
    throw InputError(map.At("id", fmt::format("{} is given twice; choose another", Quoted(id))));
  }
}

Mesh ReadClutterMesh(const YamlMap& map, Random random) {
  std::string shape;
  ReadFields(map, {Option("shape", &shape, "", ClutterShapes())},
             {"size", "position", "yaw_deg", "on", "colour"});
  if (!map.Has("shape")) throw InputError(map.At("shape", "is missing; add it"));
  const Eigen::Vector3d size = ReadSize(map, "size");
  const Colour colour = map.Has("colour") ? ReadColour(map, "colour") : DrawClutterColour(shape, random);
  return ClutterMesh(shape, size, colour, random);
}

}  // namespace

std::vector<SceneObject> ReadObjects(const YamlMap& file, const Scene& scene,
                                     const std::vector<CadInstance>& collection) {
  std::vector<SceneObject> objects;
  std::vector<NamedSolid> solids;
  for (const YamlMap& map : MapsIfAny(file, "objects")) {
    map.CheckKeys({"id", "category", "instance", "at_most", "position", "yaw_deg", "on"});
    SceneObject object;
    object.id = ReadName(map, "id");
    CheckIsNew(map, object.id, objects);
    Random random = MakeRandom(scene.seed, objects.size());
    object.instance = ChosenInstance(map, collection, objects, random);
    const Place place = ReadPlace(map, objects);
    object.T_world_object = StandingOn(place.T_world_place, object.instance);
    const NamedSolid solid{object.id, MakeSolid(object.instance.mesh, object.T_world_object)};
    CheckFree(map, place, solid, scene.room, solids);
    solids.push_back(solid);
    objects.push_back(object);
  }
  return objects;
}

std::vector<ClutterPiece> ReadClutter(const YamlMap& file, const Scene& scene) {
  std::vector<ClutterPiece> clutter;
  std::vector<NamedSolid> solids = MakeSolids(scene.objects);
  for (const YamlMap& map : MapsIfAny(file, "clutter")) {
    const Mesh mesh = ReadClutterMesh(map, MakeRandom(scene.seed, clutter.size()));
    const Place place = ReadPlace(map, scene.objects);
    const NamedSolid solid{fmt::format("clutter[{}]", clutter.size()), MakeSolid(mesh, place.T_world_place)};
    CheckFree(map, place, solid, scene.room, solids);
    solids.push_back(solid);
    clutter.push_back({mesh, place.T_world_place});
  }
  return clutter;
}

}  // namespace armature
