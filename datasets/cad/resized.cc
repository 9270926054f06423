// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/resized.h"

#include "datasets/cad/edge_ends.h"

namespace armature {

CadInstance Resized(CadInstance instance, const Eigen::Vector3d& size) {
  const Eigen::Vector3d factors = size.cwiseQuotient(instance.size);
  for (Part& part : instance.mesh.parts) {
    part.T_mesh_part.translation() = part.T_mesh_part.translation().cwiseProduct(factors).eval();
    for (Quad& quad : part.quads) {
      for (Eigen::Vector3d& corner : quad.corners) corner = corner.cwiseProduct(factors).eval();
    }
  }
  instance.wireframe.midpoints = (factors.asDiagonal() * instance.wireframe.midpoints).eval();
  instance.wireframe.directions = (factors.asDiagonal() * instance.wireframe.directions).eval();
  instance.size = size;
  return instance;
}

CadInstance Loaded(CadInstance instance) {
  if (!instance.read_mesh) return instance;
  const Mesh mesh = instance.read_mesh();
  const Eigen::AlignedBox3d box = BoundingBox(mesh);
  instance.mesh = Shifted(mesh, -box.center());
  instance.wireframe = Shifted(instance.wireframe, -box.center());
  instance.size = box.sizes();
  instance.read_mesh = nullptr;
  return instance;
}

}  // namespace armature
