// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/scene/solid.h"

#include <algorithm>

namespace armature {
namespace {

constexpr double kCommonVolume = 1e-6;  // cubic metres in common

OrientedBox Placed(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& T_world_frame) {
  return {T_world_frame * Eigen::Translation3d(box.center()), box.sizes()};
}

OrientedBox PartBox(const Part& part, const Eigen::Isometry3d& T_world_mesh) {
  const Eigen::Isometry3d T_part_mesh = part.T_mesh_part.inverse();
  Eigen::AlignedBox3d box;
  for (const Quad& quad : part.quads) {
    for (const Eigen::Vector3d& corner : quad.corners) box.extend(T_part_mesh * corner);
  }
  return Placed(box, T_world_mesh * part.T_mesh_part);
}

}  // namespace

Solid MakeSolid(const Mesh& mesh, const Eigen::Isometry3d& T_world_mesh) {
  Solid solid;
  solid.around = Placed(BoundingBox(mesh), T_world_mesh);
  for (const Part& part : mesh.parts) solid.parts.push_back(PartBox(part, T_world_mesh));
  return solid;
}

bool Overlap(const Solid& a, const Solid& b) {
  const auto collide = [](const OrientedBox& p, const OrientedBox& q) {
    return IntersectionVolume(p, q) > kCommonVolume;
  };
  return collide(a.around, b.around) &&
         std::any_of(a.parts.begin(), a.parts.end(), [&](const OrientedBox& part) {
           return std::any_of(b.parts.begin(), b.parts.end(),
                              [&](const OrientedBox& other) { return collide(part, other); });
         });
}

bool IsNear(const OrientedBox& box, const Eigen::Vector3d& point, double clearance) {
  const Eigen::Vector3d local = box.T_world_box.inverse() * point;
  return (local.cwiseAbs() - 0.5 * box.size).maxCoeff() < clearance;
}

std::vector<Eigen::Vector3d> Corners(const OrientedBox& box) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d side((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
    corners.push_back(box.T_world_box * side.cwiseProduct(box.size));
  }
  return corners;
}

}  // namespace armature
