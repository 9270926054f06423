// SPDX-License-Identifier: BSD-3-Clause
// What happens to an odometry that cannot triangulate: it is lost, its scale jumps or drifts.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "datasets/simulation/odometry_noise.h"

namespace armature {

// Of each image, never of the first.
std::vector<bool> LostImages(size_t images, double fps, const OdometryNoise& noise, std::uint64_t seed);

// Factors of the scale of each motion from image i to i + 1.
std::vector<double> ScaleFactors(const std::vector<Eigen::Isometry3d>& T_world_camera,
                                 const std::vector<bool>& lost, const OdometryNoise& noise,
                                 std::uint64_t seed);

}  // namespace armature
