// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/edge_ends.h"

namespace armature {

Wireframe MakeWireframe(const std::vector<EdgeEnds>& edges) {
  const auto count = static_cast<Eigen::Index>(edges.size());
  Wireframe wireframe{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [start, end] = edges[static_cast<size_t>(i)];
    wireframe.midpoints.col(i) = (start + end) / 2;
    wireframe.directions.col(i) = end - start;
  }
  return wireframe;
}

Wireframe Shifted(const Wireframe& wireframe, const Eigen::Vector3d& shift) {
  return {wireframe.midpoints.colwise() + shift, wireframe.directions};
}

}  // namespace armature
