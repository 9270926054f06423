// SPDX-License-Identifier: BSD-3-Clause
// A mesh put together from the vertices and polygons of a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace armature {

class MeshBuilder {
 public:
  // For messages.
  explicit MeshBuilder(std::filesystem::path file) : file_(std::move(file)) {}

  // All throw InputError naming the file and the line it was read from; line 0: it is not known.

  // Three finite numbers.
  void AddVertex(const Eigen::Vector3d& vertex, int line);
  // Becomes triangles (polygon_triangles.h). The corners are indices of vertices already added.
  void AddPolygon(std::span<const std::int64_t> corners, int line);
  // At least one triangle is needed.
  TriangleMesh Build() const;

  std::int64_t vertices() const { return static_cast<std::int64_t>(vertices_.size()); }
  // "file:line"
  std::string At(int line) const;

 private:
  std::filesystem::path file_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3i> triangles_;
};

}  // namespace armature
