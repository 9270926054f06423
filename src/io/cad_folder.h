// SPDX-License-Identifier: BSD-3-Clause
// Collections of annotated CAD models on disk: those that `armature generate` writes and
// published tables of key points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "category/cad_model.h"

namespace armature {

// Reads what is there of (file: names of the instances, surfaces):
//   instances.csv                     armature:ID            meshes
//   keypointnet_chair_kp10.csv        keypointnet:MODEL_ID   keypointnet_chair_boxes.txt
//   shapeassembly_table_kp12.csv      shapeassembly:ANNO_ID  shapeassembly_table_boxes.txt
//   modelnet40_laptop_autokp6.csv     modelnet40:FILE        modelnet40_laptop/FILE, where it is there
// A model without surface takes its annotated edges' bounding box. One after the other: generated models in
// the order of their file; those of a published table by name, of rows with one name the last. Throws
// InputError: none of the files exists, or one is malformed. Categories without specification are left out.
std::vector<CadModel> ReadCadFolder(const std::filesystem::path& folder,
                                    const std::vector<CategorySpec>& specs);

}  // namespace armature
