// SPDX-License-Identifier: BSD-3-Clause
// The box that a perfect detector draws around a real object, which reaches beyond its wireframe.
#pragma once

#include "association/box_constraints.h"

namespace armature::testing {

inline Box PaddedBox(const Camera& camera, const CategorySpec& spec, const ProjectedWireframe& projected,
                     const Eigen::Matrix3d& R_camera_object) {
  const std::array<ExtremePoint, 4> extremes = Extremes(projected);
  const Eigen::Vector2d reach = camera.fx * ImagePadding(spec, R_camera_object);
  std::array<double, 4> at{};
  for (size_t side = 0; side < 4; ++side) {
    const double padding = reach(static_cast<Eigen::Index>(side % 2)) * extremes[side].inverse_z;
    at[side] = extremes[side].pixel + (side < 2 ? -padding : padding);
  }
  return {at[0], at[1], at[2] - at[0], at[3] - at[1]};
}

}  // namespace armature::testing
