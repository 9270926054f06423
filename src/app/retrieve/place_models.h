// SPDX-License-Identifier: BSD-3-Clause
// The map of a run with the retrieved CAD models in it (paper, figure 1).
#pragma once

#include <string>
#include <vector>

#include "app/retrieve/retrieve_run.h"
#include "drawing/map_scene.h"

namespace armature {

struct PlacedScene {
  MapScene scene;
  std::vector<std::string> missing;  // a line a model that could not be placed: which and why
};

// The map's cameras, wireframes and of each object its nearest CAD model of which there is a surface: where
// it was fitted to the images, else at the object's pose. `root`: the library's folder of surfaces.
PlacedScene PlaceModels(const RunRetrieval& retrieval, const std::filesystem::path& root);

// map.ply and map.png in the folder.
void WriteScene(const MapScene& scene, const std::filesystem::path& folder);

}  // namespace armature
