// SPDX-License-Identifier: BSD-3-Clause
// Published CAD models as solids with materials: they come without, or with plain colours.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "drawing/mesh.h"
#include "geometry/triangle_mesh.h"

namespace armature {

struct FurnitureMaterials {
  Material body;   // seats, backs, tops
  Material frame;  // legs and other slender parts
};

// Such as suit the category; the same for the same seed.
FurnitureMaterials DrawFurnitureMaterials(const std::string& category, std::uint64_t seed);

// The boxes of one model in a table of boxes (io/box_table.h), a part each. `T_object_file`: rigid up to one
// scale. Throws InputError: malformed, no box of this id.
Mesh BoxFurniture(const std::filesystem::path& file, const std::string& id,
                  const Eigen::Affine3d& T_object_file, const FurnitureMaterials& materials);

// The pieces of a mesh that hang together, a part each (by colour, where there are colours), with their
// triangles turned outwards: published ones are not. Metres.
Mesh TriangleFurniture(const TriangleMesh& mesh, const FurnitureMaterials& materials);

}  // namespace armature
