// SPDX-License-Identifier: BSD-3-Clause
// A scene that takes a second to generate: a table and a laptop in a closet, in small pictures.
#pragma once

#include <map>
#include <string>

#include "support/program.h"

namespace armature::testing {

// Everything is detected, and nothing else.
inline const char* const kSmallScene = R"(name: den
about: A desk in a closet
seed: 3
frames: 4
camera: {width: 160, height: 120, fx: 130, fy: 130}
room: {size: [2.2, 2.4, 2], pictures: 0, clutter: 0, table_clutter: 0}
objects:
  - {id: desk, category: table, at_most: [1.3, 0.8], position: [0, 0.55], yaw_deg: 10}
  - {id: pc, category: laptop, on: desk, position: [0.1, 0.05], yaw_deg: -20}
lamps:
  - {position: [0, 0, 1.9], size: [0.5, 0.5]}
path:
  kind: keyframes
  height: 1.3
  pitch_deg: 20
  keyframes:
    - {position: [-0.3, -1], heading_deg: 80}
    - {position: [0.3, -1], heading_deg: 97}
detections: {missed: 0, false_alarms: 0, min_visible: 0.1, min_size_px: 5}
)";

// The first `frames` pictures of the small scene, into FOLDER/out/den.
inline ProgramResult GenerateSmallScene(const TempFolder& folder, int frames,
                                        const std::vector<std::string>& more = {}) {
  const std::string file = folder.Write("den_scene.yaml", kSmallScene);
  std::vector<std::string> arguments = {"generate", "--scene",      file,       "--without-cad",
                                        "--out",    folder / "out", "--frames", std::to_string(frames)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunOk(arguments);
}

// The same into FOLDER/out/den, for tests that only use it: generated once for all tests of a program.
inline void CopySmallScene(const TempFolder& folder, int frames) {
  static std::map<int, TempFolder> scenes;
  const auto [scene, is_new] = scenes.try_emplace(frames);
  if (is_new) GenerateSmallScene(scene->second, frames);
  std::filesystem::copy(scene->second / "out", folder / "out", std::filesystem::copy_options::recursive);
}

}  // namespace armature::testing
