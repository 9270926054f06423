// SPDX-License-Identifier: BSD-3-Clause
// Objects and clutter of a scene file.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "datasets/scene/clutter.h"
#include "datasets/scene/scene.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"
#include "datasets/scene/solid.h"
#include "datasets/scene/support.h"
#include "geometry/random.h"
#include "geometry/rotation.h"
#include "io/yaml_support.h"

namespace armature {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

// The frame of a place: on the surface that carries it, z up; things face its -y.
struct Place {
  Eigen::Isometry3d T_world_place = Eigen::Isometry3d::Identity();
  std::optional<SceneObject> support;  // nothing: the floor
};

struct NamedSolid {
  std::string name;
  Solid solid;
};

constexpr double kTouching = 1e-6;  // metres, of rounding

SceneObject ReadSupport(const YamlMap& map, const std::vector<SceneObject>& objects) {
  const std::string id = map.Text("on");
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [&](const SceneObject& object) { return object.id == id; });
  if (found == objects.end()) {
    std::vector<std::string> known;
    known.reserve(objects.size());
    for (const SceneObject& object : objects) known.push_back(object.id);
    throw InputError(fmt::format("{}: {} (only objects listed before it count)", map.Where("on"),
                                 UnknownNameMessage("object", id, known)));
  }
  if (!IsSupport(*found)) {
    throw InputError(map.At("on", fmt::format("is {}, a {}; only tables carry something, name one or leave "
                                              "the key out",
                                              Quoted(id), found->instance.category)));
  }
  return *found;
}

// Whether all corners are within the size around the frame's origin, along its x and y.
bool IsWithin(const OrientedBox& box, const Isometry3d& T_world_frame, const Eigen::Vector2d& size) {
  const Isometry3d T_frame_world = T_world_frame.inverse();
  const std::vector<Vector3d> corners = Corners(box);
  return std::all_of(corners.begin(), corners.end(), [&](const Vector3d& corner) {
    const Eigen::Vector2d at = (T_frame_world * corner).head<2>();
    return (at.cwiseAbs() - 0.5 * size).maxCoeff() < kTouching;
  });
}

void CheckEdges(const YamlMap& map, const SceneObject& support, const NamedSolid& solid) {
  const Eigen::Vector2d top(support.instance.size.x(), support.instance.size.z());
  if (IsWithin(solid.solid.around, FindTop(support), top)) return;
  throw InputError(
      map.At("position", fmt::format("lets {} stick out over the edge of {}, whose top is {:.2f} "
                                     "x {:.2f} m; move it inwards or turn it",
                                     solid.name, support.id, top.x(), top.y())));
}

void CheckRoom(const YamlMap& map, const Room& room, const NamedSolid& solid) {
  const OrientedBox& box = solid.solid.around;
  double top = 0;
  for (const Vector3d& corner : Corners(box)) top = std::max(top, corner.z());
  if (IsWithin(box, Isometry3d::Identity(), room.size.head<2>()) && top < room.size.z()) return;
  throw InputError(map.At("position", fmt::format("lets {} reach out of the room of {} x {} x {} m around "
                                                  "[0, 0]; move it inwards",
                                                  solid.name, room.size.x(), room.size.y(), room.size.z())));
}

// Throws InputError when `on` is not one of the objects, or not one that carries anything (a table).
Place ReadPlace(const YamlMap& map, const std::vector<SceneObject>& objects) {
  const Eigen::Vector2d position = ReadPair(map, "position");
  const double yaw = map.Has("yaw_deg") ? map.Number("yaw_deg") * kDegree : 0;
  const Eigen::AngleAxisd turned(yaw, Vector3d::UnitZ());
  if (!map.Has("on")) return {Translation3d(position.x(), position.y(), 0) * turned, std::nullopt};
  const SceneObject support = ReadSupport(map, objects);
  return {FindTop(support) * Translation3d(position.x(), -position.y(), 0) * turned, support};
}

// Throws InputError at the map's `position` when the solid sticks out of the room or over the edge of its
// support, or overlaps one of the others.
void CheckFree(const YamlMap& map, const Place& place, const NamedSolid& solid, const Room& room,
               const std::vector<NamedSolid>& others) {
  CheckRoom(map, room, solid);
  if (place.support) CheckEdges(map, *place.support, solid);
  for (const NamedSolid& other : others) {
    if (!Overlap(solid.solid, other.solid)) continue;
    throw InputError(map.At(
        "position", fmt::format("lets {} overlap {}; move or turn one of them", solid.name, other.name)));
  }
}

std::vector<NamedSolid> MakeSolids(const std::vector<SceneObject>& objects) {
  std::vector<NamedSolid> solids;
  solids.reserve(objects.size());
  for (const SceneObject& object : objects) {
    solids.push_back({object.id, MakeSolid(object.instance.mesh, object.T_world_object)});
  }
  return solids;
}

using Instances = std::vector<const CadInstance*>;

std::vector<std::string> Categories(const std::vector<CadInstance>& collection) {
  std::vector<std::string> categories;
  for (const CadInstance& instance : collection) {
    const bool is_known =
        std::find(categories.begin(), categories.end(), instance.category) != categories.end();
    if (!is_known) categories.push_back(instance.category);
  }
  return categories;
}

Instances OfCategory(const YamlMap& map, const std::vector<CadInstance>& collection) {
  const std::string category = map.Text("category");
  Instances instances;
  for (const CadInstance& instance : collection) {
    if (instance.category == category) instances.push_back(&instance);
  }
  if (!instances.empty()) return instances;
  throw InputError(fmt::format("{}: {}", map.Where("category"),
                               UnknownNameMessage("category", category, Categories(collection))));
}

[[noreturn]] void ThrowUnknown(const YamlMap& map, const std::string& id, const Instances& instances,
                               const std::vector<CadInstance>& collection) {
  for (const CadInstance& other : collection) {
    if (other.id != id) continue;
    throw InputError(map.At("instance", fmt::format("is {}, a {}; name a {}, or correct the category",
                                                    Quoted(id), other.category, map.Text("category"))));
  }
  std::vector<std::string> known{"sampled"};
  for (const CadInstance* instance : instances) known.push_back(instance->id);
  throw InputError(fmt::format("{}: {}", map.Where("instance"), UnknownNameMessage("instance", id, known)));
}

// The held-out ones that are not too large.
Instances Candidates(const YamlMap& map, const Instances& instances) {
  Eigen::Vector2d most = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  if (map.Has("at_most")) most = ReadPair(map, "at_most");
  Instances candidates;
  for (const CadInstance* instance : instances) {
    const bool fits = instance->size.x() <= most.x() && instance->size.z() <= most.y();
    if (instance->held_out && fits) candidates.push_back(instance);
  }
  if (!candidates.empty()) return candidates;
  const std::string key = map.Has("at_most") ? "at_most" : "instance";
  throw InputError(map.At(
      key, fmt::format("leaves no held-out {} to sample; allow larger ones, name an instance, or draw a "
                       "larger collection",
                       map.Text("category"))));
}

// Those that none of the objects is; all where that leaves none.
Instances Fresh(const Instances& instances, const std::vector<SceneObject>& objects) {
  Instances fresh;
  for (const CadInstance* instance : instances) {
    const bool is_used = std::any_of(objects.begin(), objects.end(), [&](const SceneObject& object) {
      return object.instance.id == instance->id;
    });
    if (!is_used) fresh.push_back(instance);
  }
  return fresh.empty() ? instances : fresh;
}

// The instance that an object's `category`, `instance` and `at_most` choose: the named one, or one drawn
// among the held-out ones that are not larger, and not among the `others` while there are any besides. Throws
// InputError when there is none.
const CadInstance& ChosenInstance(const YamlMap& map, const std::vector<CadInstance>& collection,
                                  const std::vector<SceneObject>& others, Random& random) {
  const Instances instances = OfCategory(map, collection);
  const std::string id = map.Has("instance") ? map.Text("instance") : "sampled";
  if (id == "sampled") {
    const Instances candidates = Fresh(Candidates(map, instances), others);
    return *candidates[static_cast<size_t>(random.Uniform(0, static_cast<double>(candidates.size())))];
  }
  if (map.Has("at_most")) {
    throw InputError(map.At("at_most", "limits what is sampled, but the instance is named; leave one out"));
  }
  for (const CadInstance* instance : instances) {
    if (instance->id == id) return *instance;
  }
  ThrowUnknown(map, id, instances, collection);
}

// Of the i-th thing in a list.
Random MakeRandom(std::uint64_t seed, size_t i) { return Random(1000003 * seed + i); }

void CheckIsNew(const YamlMap& map, const std::string& id, const std::vector<SceneObject>& objects) {
  for (const SceneObject& object : objects) {
    if (object.id != id) continue;
    throw InputError(map.At("id", fmt::format("{} is given twice; choose another", Quoted(id))));
  }
}

Mesh ReadClutterMesh(const YamlMap& map, Random random) {
  map.CheckKeys({"shape", "size", "position", "yaw_deg", "on", "colour"});
  if (!map.Has("shape")) throw InputError(map.At("shape", "is missing; add it"));
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
