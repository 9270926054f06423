// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/surfaces.h"

#include <algorithm>

namespace armature {

using Eigen::Vector3d;

namespace {

SurfaceQuad PlaceQuad(const Quad& quad, const Eigen::Isometry3d& T_world_mesh,
                      const Eigen::Isometry3d& T_mesh_part, int part) {
  SurfaceQuad placed;
  for (size_t i = 0; i < 4; ++i) placed.corners[i] = T_world_mesh * quad.corners[i];
  const auto& [a, b, c, d] = placed.corners;
  placed.normal = (c - a).cross(d - b).normalized();
  placed.normal_part = ((T_world_mesh * T_mesh_part).linear().transpose() * placed.normal).cast<float>();
  placed.part = part;
  return placed;
}

}  // namespace

Vector3d SurfaceQuad::At(double u, double v) const {
  const auto& [a, b, c, d] = corners;
  if (u + v <= 1) return a + u * (b - a) + v * (d - a);
  return c + (1 - u) * (d - c) + (1 - v) * (b - c);
}

double SurfaceQuad::Width() const {
  return std::max((corners[1] - corners[0]).norm(), (corners[2] - corners[3]).norm());
}

double SurfaceQuad::Height() const {
  return std::max((corners[3] - corners[0]).norm(), (corners[2] - corners[1]).norm());
}

double SurfaceQuad::Area() const {
  return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]).norm();
}

Surfaces ListSurfaces(const std::vector<PlacedMesh>& meshes) {
  Surfaces surfaces;
  for (const PlacedMesh& placed : meshes) {
    std::vector<int>& first_quad = surfaces.first_quad.emplace_back();
    for (const Part& part : placed.mesh.parts) {
      first_quad.push_back(static_cast<int>(surfaces.quads.size()));
      const int index = static_cast<int>(surfaces.parts.size());
      const Eigen::Isometry3d T_world_part = placed.T_world_mesh * part.T_mesh_part;
      surfaces.parts.push_back({Paint(part.material), T_world_part.inverse().cast<float>()});
      for (const Quad& quad : part.quads) {
        surfaces.quads.push_back(PlaceQuad(quad, placed.T_world_mesh, part.T_mesh_part, index));
      }
    }
  }
  return surfaces;
}

}  // namespace armature
