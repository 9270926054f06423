// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/instance_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "datasets/scene/scene_fields.h"

namespace armature {
namespace {

constexpr const char* kOwnCollection = "armature";

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

// Those of the map's `collection`; all where it has none.
Instances OfCollection(const YamlMap& map, const Instances& instances) {
  if (!map.Has("collection")) return instances;
  const std::string name = map.Text("collection");
  Instances chosen;
  std::vector<std::string> known;
  for (const CadInstance* instance : instances) {
    if (instance->collection == name) chosen.push_back(instance);
    if (known.empty() || known.back() != instance->collection) known.push_back(instance->collection);
  }
  if (!chosen.empty()) return chosen;
  throw InputError(fmt::format("{}: {} (others are given by --collection)", map.Where("collection"),
                               UnknownNameMessage("collection", name, known)));
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

// The held-out ones that are not too large; of our own families unless the map names another collection.
Instances Candidates(const YamlMap& map, const Instances& instances) {
  Eigen::Vector2d most = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  if (map.Has("at_most")) most = ReadPair(map, "at_most");
  Instances candidates;
  for (const CadInstance* instance : instances) {
    if (!map.Has("collection") && instance->collection != kOwnCollection) continue;
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

}  // namespace

const CadInstance& ChosenInstance(const YamlMap& map, const std::vector<CadInstance>& collection,
                                  const std::vector<SceneObject>& others, Random& random) {
  const Instances instances = OfCollection(map, OfCategory(map, collection));
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

}  // namespace armature
