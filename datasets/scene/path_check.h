// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "datasets/scene/scene.h"
#include "io/yaml_support.h"

namespace armature {

// Throws InputError when the camera, anywhere on its path, is nearer than 0.1 m to an object, to a piece of
// clutter or to the room's walls, floor or ceiling, or outside of the room.
void CheckPath(const YamlMap& file, const Scene& scene);

}  // namespace armature
