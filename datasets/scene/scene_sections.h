// SPDX-License-Identifier: BSD-3-Clause
// The sections of a scene file, a reader each. All take the whole file's map, return the defaults where the
// section is absent, and throw InputError naming file, line and remedy.
#pragma once

#include <vector>

#include "datasets/scene/scene.h"
#include "io/yaml_support.h"

namespace armature {

Camera ReadCamera(const YamlMap& file);
CameraPath ReadPath(const YamlMap& file);
CameraEffects ReadEffects(const YamlMap& file);
OdometryNoise ReadOdometryNoise(const YamlMap& file);
DetectorNoise ReadDetectorNoise(const YamlMap& file);

Room ReadRoom(const YamlMap& file);
// By default two below the ceiling.
std::vector<Lamp> ReadLamps(const YamlMap& file, const Room& room);

// Needs the scene's seed and room.
std::vector<SceneObject> ReadObjects(const YamlMap& file, const Scene& scene,
                                     const std::vector<CadInstance>& collection);
// The pieces of the file; needs the scene's seed, room and objects.
std::vector<ClutterPiece> ReadClutter(const YamlMap& file, const Scene& scene);

}  // namespace armature
