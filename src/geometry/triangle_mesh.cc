// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/triangle_mesh.h"

namespace armature {

TriangleMesh Moved(const Eigen::Affine3d& T, TriangleMesh mesh) {
  mesh.vertices = T * mesh.vertices;
  return mesh;
}

void Append(const TriangleMesh& more, const ColourBytes& colour, TriangleMesh& mesh) {
  const Eigen::Index vertices = mesh.vertices.cols(), triangles = mesh.size(), added = more.size();
  if (mesh.colours.cols() != triangles) mesh.colours = colour.replicate(1, triangles);
  mesh.vertices.conservativeResize(3, vertices + more.vertices.cols());
  mesh.vertices.rightCols(more.vertices.cols()) = more.vertices;
  mesh.triangles.conservativeResize(3, triangles + added);
  mesh.triangles.rightCols(added) = more.triangles.array() + static_cast<int>(vertices);
  mesh.colours.conservativeResize(3, triangles + added);
  if (more.colours.cols() == added) {
    mesh.colours.rightCols(added) = more.colours;
  } else {
    mesh.colours.rightCols(added).colwise() = colour;
  }
}

}  // namespace armature
