// SPDX-License-Identifier: BSD-3-Clause
// Meshes as files that every viewer opens.
#pragma once

#include <string>

#include "geometry/triangle_mesh.h"

namespace armature {

// What has a colour in the file: triangles, where each vertex is written once, or vertices, which all viewers
// show; then a vertex is written for each colour around it.
enum class PlyColours { kOfTriangles, kOfVertices };

// The bytes of a binary little-endian PLY file: vertices (x, y, z as float), triangles (vertex_indices), and
// colours (red, green, blue, 0-255); a mesh without colours is grey. `comment`: one line of its header.
std::string PlyText(const TriangleMesh& mesh, PlyColours colours, const std::string& comment);

}  // namespace armature
