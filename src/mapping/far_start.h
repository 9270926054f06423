// SPDX-License-Identifier: BSD-3-Clause
// Poses far from the origin, as in UTM coordinates. Ceres stops where a step is 1e-8 of its unknowns' size,
// which is centimetres there: graphs are solved about their first pose then.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace armature {

// The first pose's position, where it is further from the origin than a hundred times any other pose is from
// it; none where the poses may stay as they are.
std::optional<Eigen::Vector3d> FindFarStart(const std::vector<Eigen::Isometry3d>& poses);

}  // namespace armature
