// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/mesh.h"

namespace armature {

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

}  // namespace armature
