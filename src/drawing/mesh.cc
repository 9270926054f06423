// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/mesh.h"

#include <cmath>

namespace armature {
namespace {

struct Triangles {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3i> corners;
  std::vector<ColourBytes> colours;
};

// Index of the vertex among those from `first` on; adds it where it is new.
int VertexIndex(const Eigen::Vector3f& vertex, size_t first, Triangles& triangles) {
  for (size_t i = first; i < triangles.vertices.size(); ++i) {
    if (triangles.vertices[i] == vertex) return static_cast<int>(i);
  }
  triangles.vertices.push_back(vertex);
  return static_cast<int>(triangles.vertices.size() - 1);
}

ColourBytes Bytes(const Colour& colour) {
  const auto byte = [](double share) { return static_cast<unsigned char>(std::lround(255 * share)); };
  return {byte(colour.x()), byte(colour.y()), byte(colour.z())};
}

void AddPart(const Part& part, Triangles& triangles) {
  const size_t first = triangles.vertices.size();
  for (const Quad& quad : part.quads) {
    Eigen::Vector4i v;
    for (int i = 0; i < 4; ++i) {
      v[i] = VertexIndex(quad.corners[static_cast<size_t>(i)].cast<float>(), first, triangles);
    }
    triangles.corners.emplace_back(v[0], v[1], v[2]);
    if (v[3] != v[2]) triangles.corners.emplace_back(v[0], v[2], v[3]);
  }
  triangles.colours.resize(triangles.corners.size(), Bytes(part.material.colour));
}

}  // namespace

Eigen::AlignedBox3d BoundingBox(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Part& part : mesh.parts) {
    for (const Quad& quad : part.quads) {
      for (const Eigen::Vector3d& corner : quad.corners) box.extend(corner);
    }
  }
  return box;
}

Mesh Shifted(const Mesh& mesh, const Eigen::Vector3d& shift) {
  Mesh shifted = mesh;
  for (Part& part : shifted.parts) {
    part.T_mesh_part.pretranslate(shift);
    for (Quad& quad : part.quads) {
      for (Eigen::Vector3d& corner : quad.corners) corner += shift;
    }
  }
  return shifted;
}

TriangleMesh MakeTriangles(const Mesh& mesh) {
  Triangles triangles;
  for (const Part& part : mesh.parts) AddPart(part, triangles);
  const auto vertices = static_cast<Eigen::Index>(triangles.vertices.size());
  const auto count = static_cast<Eigen::Index>(triangles.corners.size());
  TriangleMesh made{Eigen::Matrix3Xd(3, vertices), Eigen::Matrix3Xi(3, count), {}};
  made.colours.resize(3, count);
  for (Eigen::Index i = 0; i < vertices; ++i) {
    made.vertices.col(i) = triangles.vertices[static_cast<size_t>(i)].cast<double>();
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    made.triangles.col(i) = triangles.corners[static_cast<size_t>(i)];
    made.colours.col(i) = triangles.colours[static_cast<size_t>(i)];
  }
  return made;
}

}  // namespace armature
