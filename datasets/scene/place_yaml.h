// SPDX-License-Identifier: BSD-3-Clause
// Where a scene file puts things: `position`, `yaw_deg` and `on` of objects and clutter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/scene/scene.h"
#include "datasets/scene/solid.h"
#include "datasets/scene/support.h"
#include "io/yaml_support.h"

namespace armature {

// The frame of a place: on the surface that carries it, z up; things face its -y.
struct Place {
  Eigen::Isometry3d T_world_place = Eigen::Isometry3d::Identity();
  std::optional<SceneObject> support;  // nothing: the floor
};

// Throws InputError when `on` is not one of the objects, or not one that carries anything (a table).
Place ReadPlace(const YamlMap& map, const std::vector<SceneObject>& objects);

struct NamedSolid {
  std::string name;
  Solid solid;
};

// Throws InputError at the map's `position` when the solid sticks out of the room or over the edge of its
// support, or overlaps one of the others.
void CheckFree(const YamlMap& map, const Place& place, const NamedSolid& solid, const Room& room,
               const std::vector<NamedSolid>& others);

std::vector<NamedSolid> MakeSolids(const std::vector<SceneObject>& objects);

}  // namespace armature
