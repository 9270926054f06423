// SPDX-License-Identifier: BSD-3-Clause
// Where the things of a scene file stand, and whether they can stand there.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "datasets/scene/scene.h"
#include "datasets/scene/solid.h"
#include "geometry/random.h"
#include "io/yaml_support.h"

namespace armature {

// The frame of a place: on the surface that carries it, z up; things face its -y.
struct Place {
  Eigen::Isometry3d T_world_place = Eigen::Isometry3d::Identity();
  std::optional<SceneObject> support;  // nothing: the floor
};

struct NamedSolid {
  std::string name;
  Solid solid;
};

std::vector<NamedSolid> MakeSolids(const std::vector<SceneObject>& objects);

// From `position`, `yaw_deg` and `on`. Throws InputError when `on` is not one of the objects, or not one that
// carries anything (a table).
Place ReadPlace(const YamlMap& map, const std::vector<SceneObject>& objects);

// Throws InputError at the map's `position` when the solid sticks out of the room or over the edge of its
// support, or overlaps one of the others.
void CheckFree(const YamlMap& map, const Place& place, const NamedSolid& solid, const Room& room,
               const std::vector<NamedSolid>& others);

// Of the i-th thing in a list.
inline Random MakeRandom(std::uint64_t seed, size_t i) { return Random(1000003 * seed + i); }

}  // namespace armature
