// SPDX-License-Identifier: BSD-3-Clause
// Stands in for a monocular visual odometry: unknown scale that drifts, heading that drifts, noise.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "datasets/simulation/odometry_noise.h"

namespace armature {

// T_odom_camera of each image; the first camera is the origin. `T_world_camera`: the whole path, world's z
// up. Motion i of n, T_i^-1 T_i+1, gets its translation scaled by scale (1 + scale_drift)^(i / (n - 1)), is
// turned about the vertical by the n-th part of heading_drift, and noise is added to both.
std::vector<Eigen::Isometry3d> SimulateOdometry(const std::vector<Eigen::Isometry3d>& T_world_camera,
                                                const OdometryNoise& noise, std::uint64_t seed);

}  // namespace armature
