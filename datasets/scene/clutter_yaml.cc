// SPDX-License-Identifier: BSD-3-Clause
// Clutter and distractors of a scene file.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "datasets/scene/clutter.h"
#include "datasets/scene/placing.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"

namespace armature {
namespace {

Mesh ReadClutterMesh(const YamlMap& map, Random random) {
  const std::string shape = map.Text("shape");
  const auto& shapes = ClutterShapes();
  if (std::find(shapes.begin(), shapes.end(), shape) == shapes.end()) {
    throw InputError(
        fmt::format("{}: {}", map.Where("shape"), UnknownNameMessage("value of shape", shape, shapes)));
  }
  const Eigen::Vector3d size = ReadSize(map, "size");
  const Colour colour = map.Has("colour") ? ReadColour(map, "colour") : DrawClutterColour(shape, random);
  return ClutterMesh(shape, size, colour, random);
}

// Empty where it has none.
std::string ReadId(const YamlMap& map, const std::vector<SceneObject>& objects,
                   const std::vector<ClutterPiece>& clutter) {
  if (!map.Has("id")) return "";
  std::string id = ReadName(map, "id");
  const auto is_same = [&](const auto& other) { return other.id == id; };
  if (std::none_of(objects.begin(), objects.end(), is_same) &&
      std::none_of(clutter.begin(), clutter.end(), is_same))
    return id;
  throw InputError(map.At("id", fmt::format("{} is given twice; choose another", Quoted(id))));
}

}  // namespace

std::vector<ClutterPiece> ReadClutter(const YamlMap& file, const Scene& scene) {
  std::vector<ClutterPiece> clutter;
  std::vector<NamedSolid> solids = MakeSolids(scene.objects);
  for (const YamlMap& map : MapsIfAny(file, "clutter")) {
    map.CheckKeys({"id", "shape", "size", "position", "yaw_deg", "on", "colour"});
    const std::string id = ReadId(map, scene.objects, clutter);
    const Mesh mesh = ReadClutterMesh(map, MakeRandom(scene.seed, clutter.size()));
    const Place place = ReadPlace(map, scene.objects);
    const std::string name = id.empty() ? fmt::format("clutter[{}]", clutter.size()) : id;
    const NamedSolid solid{name, MakeSolid(mesh, place.T_world_place)};
    CheckFree(map, place, solid, scene.room, solids);
    solids.push_back(solid);
    clutter.push_back({mesh, place.T_world_place, map.Text("shape"), id});
  }
  return clutter;
}

}  // namespace armature
