// SPDX-License-Identifier: BSD-3-Clause
// CAD models' surfaces on disk.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/triangle_mesh.h"

namespace armature {

// By the name's ending: .ply, .obj, .off. Polygons become triangles. Vertices in the file's
// unit and frame. Throws InputError naming the file (and, of .obj and .off, the line): missing, malformed,
// another ending, a corner that is no vertex, a coordinate that is not finite, no triangle.
TriangleMesh ReadMesh(const std::filesystem::path& file);

// The boxes of one CAD model in a table of boxes, as 12 triangles each; the file's unit and frame. A line is
// two ids, then centre 3, half size 3, axes 9 (row-major, a row an axis). `id` is looked for among both ids.
// Throws InputError naming file and line: missing, malformed, no box of this id.
TriangleMesh ReadBoxes(const std::filesystem::path& file, const std::string& id);

// "FILE" as ReadMesh has it, "FILE#ID" as ReadBoxes has it.
// Either may have a '#' in its path.
TriangleMesh ReadGeometry(const std::filesystem::path& file_and_id);

// Whether its file is there.
bool HasGeometry(const std::filesystem::path& file_and_id);

}  // namespace armature
