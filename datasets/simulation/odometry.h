// SPDX-License-Identifier: BSD-3-Clause
// Stands in for a monocular visual odometry: unknown scale that drifts, heading that drifts, noise, losses.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "datasets/simulation/odometry_noise.h"

namespace armature {

// T_odom_camera of each image; the first camera is the origin; none where it is lost. `T_world_camera`: the
// whole path, world's z up, `fps` images a second. Motion i of n, T_i^-1 T_i+1, gets its translation scaled
// by scale (1 + scale_drift)^(i / (n - 1)) and by what jumps and turns in place made of it, is turned about
// the vertical by the n-th part of heading_drift, and noise is added to both. What happens while it is lost
// is followed, as by one that finds its place again.
std::vector<std::optional<Eigen::Isometry3d>> SimulateOdometry(
    const std::vector<Eigen::Isometry3d>& T_world_camera, double fps, const OdometryNoise& noise,
    std::uint64_t seed);

}  // namespace armature
