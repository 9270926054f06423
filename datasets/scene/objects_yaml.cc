// SPDX-License-Identifier: BSD-3-Clause
// Objects of a scene file.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "datasets/cad/lid.h"
#include "datasets/cad/resized.h"
#include "datasets/scene/instance_choice.h"
#include "datasets/scene/placing.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"
#include "datasets/scene/support.h"

namespace armature {
namespace {

void CheckIsNew(const YamlMap& map, const std::string& id, const std::vector<SceneObject>& objects) {
  for (const SceneObject& object : objects) {
    if (object.id != id) continue;
    throw InputError(map.At("id", fmt::format("{} is given twice; choose another", Quoted(id))));
  }
}

// The instance, opened as `lid_deg` says.
CadInstance Opened(const YamlMap& map, const CadInstance& instance) {
  if (!map.Has("lid_deg")) return instance;
  if (instance.category != "laptop")
    throw InputError(
        map.At("lid_deg", fmt::format("is of laptops; leave it out for a {}", instance.category)));
  double degrees = 0;
  ReadField(map, Option("lid_deg", &degrees, "", 30, 170));
  return WithLid(instance, degrees);
}

// The instance in the size that `scale` or `size` ask for; as it is without them.
CadInstance InItsSize(const YamlMap& map, const CadInstance& instance) {
  if (!map.Has("scale") && !map.Has("size")) return instance;
  if (map.Has("scale") && map.Has("size"))
    throw InputError(map.At("scale", "is given beside size, which says it already; leave one out"));
  if (map.Has("size")) return Resized(instance, ReadSize(map, "size"));
  double scale = 1;
  ReadField(map, Option("scale", &scale, "", 0.01, 100));
  return Resized(instance, scale * instance.size);
}

}  // namespace

std::vector<SceneObject> ReadObjects(const YamlMap& file, const Scene& scene,
                                     const std::vector<CadInstance>& collection) {
  std::vector<SceneObject> objects;
  std::vector<NamedSolid> solids;
  for (const YamlMap& map : MapsIfAny(file, "objects")) {
    map.CheckKeys({"id", "category", "collection", "instance", "at_most", "lid_deg", "scale", "size",
                   "position", "yaw_deg", "on"});
    SceneObject object;
    object.id = ReadName(map, "id");
    CheckIsNew(map, object.id, objects);
    Random random = MakeRandom(scene.seed, objects.size());
    object.instance = InItsSize(map, Opened(map, Loaded(ChosenInstance(map, collection, objects, random))));
    const Place place = ReadPlace(map, objects);
    object.T_world_object = StandingOn(place.T_world_place, object.instance);
    const NamedSolid solid{object.id, MakeSolid(object.instance.mesh, object.T_world_object)};
    CheckFree(map, place, solid, scene.room, solids);
    solids.push_back(solid);
    objects.push_back(object);
  }
  return objects;
}

}  // namespace armature
