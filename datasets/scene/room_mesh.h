// SPDX-License-Identifier: BSD-3-Clause
// A scene as what is rendered.
#pragma once

#include <vector>

#include "datasets/scene/scene.h"
#include "drawing/ray_scene.h"

namespace armature {

// Objects first, numbered 1, 2, ... in the order of the scene; then the room: floor, walls, ceiling, skirting
// boards, a door, a window, pictures, the lamps' housings, and clutter, the file's and scattered one.
// Distractors are numbered after the objects, in the order of Distractors(). The same for the same scene.
std::vector<PlacedMesh> SceneMeshes(const Scene& scene);

}  // namespace armature
