// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of OFF files.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"

namespace armature {

// Text; also with texture coordinates, colours or normals at the vertices (STOFF, COFF, NOFF and their
// combinations), which are left out as are colours of faces. The first line may go on with the counts, as
// some of ModelNet40 do ("OFF490 518 0"). Line breaks may stand anywhere; where there is a line for each
// vertex and each face, what else stands in it is left out. Throws as ReadMesh.
TriangleMesh ReadOff(const std::filesystem::path& file);

}  // namespace armature
