// SPDX-License-Identifier: BSD-3-Clause
// PLY through PCL.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"

namespace armature {

// Text or binary; colours are left out. Throws as ReadMesh.
TriangleMesh ReadPly(const std::filesystem::path& file);

}  // namespace armature
