// SPDX-License-Identifier: BSD-3-Clause
// The quads of all placed meshes in one list, in world coordinates.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "datasets/render/textures.h"
#include "drawing/ray_scene.h"

namespace armature {

struct SurfacePart {
  Paint paint;
  Eigen::Isometry3f T_part_world = Eigen::Isometry3f::Identity();
};

struct SurfaceQuad {
  std::array<Eigen::Vector3d, 4> corners;  // world, metres
  Eigen::Vector3d normal{0, 0, 1};         // unit, outwards
  Eigen::Vector3f normal_part{0, 0, 1};    // the same in the part's frame
  int part = 0;

  // As RayHit defines u and v: linear in each of the triangles (0, 1, 3) and (2, 3, 1).
  Eigen::Vector3d At(double u, double v) const;
  double Width() const;   // metres along u
  double Height() const;  // metres along v
  double Area() const;
};

struct Surfaces {
  std::vector<SurfacePart> parts;
  std::vector<SurfaceQuad> quads;
  std::vector<std::vector<int>> first_quad;  // of a mesh's part

  int GetQuad(const RayHit& hit) const {
    return first_quad[static_cast<size_t>(hit.mesh)][static_cast<size_t>(hit.part)] + hit.quad;
  }
  const SurfacePart& GetPart(const SurfaceQuad& quad) const { return parts[static_cast<size_t>(quad.part)]; }
};

Surfaces ListSurfaces(const std::vector<PlacedMesh>& meshes);

}  // namespace armature
