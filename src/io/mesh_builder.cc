// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_builder.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "geometry/polygon_triangles.h"

namespace armature {

std::string MeshBuilder::At(int line) const {
  return line == 0 ? file_.string() : fmt::format("{}:{}", file_.string(), line);
}

void MeshBuilder::AddVertex(const Eigen::Vector3d& vertex, int line) {
  if (!vertex.allFinite()) {
    throw InputError(fmt::format("{}: the coordinates of vertex {} are not finite numbers; repair the mesh",
                                 At(line), vertices_.size()));
  }
  vertices_.push_back(vertex);
}

void MeshBuilder::AddPolygon(std::span<const std::int64_t> corners, int line) {
  if (corners.size() < 3) {
    throw InputError(fmt::format("{}: a face has {} corners; it needs 3 or more", At(line), corners.size()));
  }
  for (const std::int64_t corner : corners) {
    if (corner >= 0 && corner < vertices()) continue;
    throw InputError(fmt::format("{}: a face has a corner at vertex {} (from 0), where there are {} vertices",
                                 At(line), corner, vertices()));
  }
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(corners.size());
  for (const std::int64_t corner : corners) positions.push_back(vertices_[static_cast<size_t>(corner)]);
  const std::vector<TriangleCorners> triangles = CutPolygon(positions);
  if (triangles.empty() && corners.size() > kMostConcaveCorners) {
    throw InputError(
        fmt::format("{}: a face of {} corners that is not convex, at most {} are cut; write "
                    "triangles",
                    At(line), corners.size(), kMostConcaveCorners));
  }
  for (const TriangleCorners& triangle : triangles) {
    triangles_.emplace_back(static_cast<int>(corners[triangle[0]]), static_cast<int>(corners[triangle[1]]),
                            static_cast<int>(corners[triangle[2]]));
  }
}

TriangleMesh MeshBuilder::Build() const {
  if (triangles_.empty()) throw InputError(fmt::format("{}: has no face; give a surface", file_.string()));
  TriangleMesh mesh{Eigen::Matrix3Xd(3, vertices_.size()), Eigen::Matrix3Xi(3, triangles_.size()), {}};
  for (size_t i = 0; i < vertices_.size(); ++i)
    mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices_[i];
  for (size_t i = 0; i < triangles_.size(); ++i) {
    mesh.triangles.col(static_cast<Eigen::Index>(i)) = triangles_[i];
  }
  return mesh;
}

}  // namespace armature
