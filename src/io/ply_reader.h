// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of PLY files. Not by PCL's reader, whose assertions end the program at headers that are right
// (colours in the order blue, green, red) and which knows no indices of 16 bits.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"

namespace armature {

// Text or binary of either byte order; elements and properties in any order and of any type; colours and all
// else are left out. Throws as ReadMesh.
TriangleMesh ReadPly(const std::filesystem::path& file);

}  // namespace armature
