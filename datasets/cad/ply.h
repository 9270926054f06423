// SPDX-License-Identifier: BSD-3-Clause
// Meshes as files that every viewer opens.
#pragma once

#include <string>

#include "drawing/mesh.h"

namespace armature {

// The bytes of a binary little-endian PLY file: vertices (x, y, z as float; metres), triangles
// (vertex_indices) with the colour of their part's material (red, green, blue, 0-255). Corners of a part
// that are the same point are one vertex.
std::string PlyText(const Mesh& mesh);

}  // namespace armature
