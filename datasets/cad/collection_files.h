// SPDX-License-Identifier: BSD-3-Clause
// The collection of CAD models as a folder:
//   instances.csv                 id,category,held_out,size_x,size_y,size_z,mesh: a row a model; held_out 0
//   or
//                                 1, the size of the mesh's bounding box in metres, the mesh's file
//   CATEGORY/ID.ply               its mesh in the object frame, metres
//   CATEGORY_edges.csv            model,edge,x1,y1,z1,x2,y2,z2: the annotated edges of those to learn from,
//   CATEGORY_edges_held_out.csv   and of the others; format `edges` of io/annotations.h, object frame, metres
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/cad/cad_instance.h"

namespace armature {

// The bytes of a model's file: PLY whose triangles have the colours of their materials.
std::string CadPlyText(const Mesh& mesh);

// Writes the files into an existing folder. Throws std::runtime_error when one cannot be written.
void WriteCollection(const std::vector<CadInstance>& collection, const std::filesystem::path& folder);

}  // namespace armature
