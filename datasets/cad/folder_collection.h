// SPDX-License-Identifier: BSD-3-Clause
// Collections of annotated CAD models on disk, as furniture of scenes.
#pragma once

#include <filesystem>
#include <vector>

#include "category/training_spec.h"
#include "datasets/cad/cad_instance.h"

namespace armature {

// The chairs, tables and laptops of a folder (io/cad_folder.h) that have a surface, in metres: those of
// unknown unit at their category's reference. Meshes are read when they are needed (Loaded). A collection is
// named as its instances' prefix says, the models of an instances.csv as their folder. Held out are those
// that instances.csv says, and of published tables the plausible ones that are kept apart by their id
// (category/kept_apart.h). Throws InputError as ReadCadFolder.
std::vector<CadInstance> ReadFolderCollection(const std::filesystem::path& folder,
                                              const std::vector<TrainingSpec>& specs);

// The shipped specifications of chairs, tables and laptops. Throws InputError.
std::vector<TrainingSpec> FurnitureSpecs();

// Our own families and the folders' collections. Throws InputError, also when two have one name.
std::vector<CadInstance> CollectFurniture(std::vector<CadInstance> own,
                                          const std::vector<std::filesystem::path>& folders);

}  // namespace armature
