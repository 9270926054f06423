// SPDX-License-Identifier: BSD-3-Clause
// Meshes written as text: Wavefront's OBJ and the OFF of Geomview.
#pragma once

#include <filesystem>

#include "geometry/triangle_mesh.h"

namespace armature {

// Vertices (v) and faces (f, also a/b/c and negative indices); all else is left out. PCL's reader is not
// used: it writes beyond its memory where a file has more normals than vertices, as many have. Throws as
// ReadMesh.
TriangleMesh ReadObj(const std::filesystem::path& file);

// A vertex or a face a line; what follows a face's corners, its colour, is left out. The first line may go on
// with the counts, as some of ModelNet40 do ("OFF490 518 0"). Throws as ReadMesh.
TriangleMesh ReadOff(const std::filesystem::path& file);

}  // namespace armature
