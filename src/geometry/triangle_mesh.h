// SPDX-License-Identifier: BSD-3-Clause
// Surfaces made of triangles: CAD models and what is drawn of a map.
#pragma once

#include <Eigen/Geometry>

namespace armature {

using ColourBytes = Eigen::Matrix<unsigned char, 3, 1>;  // red, green, blue, 0-255

// Seen from both sides: the order of a triangle's corners says nothing.
struct TriangleMesh {
  Eigen::Matrix3Xd vertices;                                // 3 x V
  Eigen::Matrix3Xi triangles;                               // 3 x T, indices of vertices
  Eigen::Matrix<unsigned char, 3, Eigen::Dynamic> colours;  // 3 x T, one a triangle; 3 x 0: not known

  Eigen::Index size() const { return triangles.cols(); }
};

// With the vertices at T * vertex.
TriangleMesh Moved(const Eigen::Affine3d& T, TriangleMesh mesh);

// All triangles of both; a mesh without colours gets `colour`.
void Append(const TriangleMesh& more, const ColourBytes& colour, TriangleMesh& mesh);

}  // namespace armature
