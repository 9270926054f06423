// SPDX-License-Identifier: BSD-3-Clause
// Draws polygons with a depth buffer, twice as fine as the picture.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "datasets/solids.h"
#include "geometry/camera.h"

namespace armature {

// Which polygon each pixel of the fine picture sees, and how far away.
struct VisibleSurfaces {
  cv::Mat1i polygon;        // index, -1: none
  cv::Mat1d inverse_depth;  // 1 / metres along the optical axis, 0 where there is none
};

// The camera whose picture is twice as wide and high and, averaged over 2 x 2 pixels, that of `camera`.
Camera TwiceAsFine(const Camera& camera);

VisibleSurfaces Rasterize(const std::vector<Polygon>& polygons, const Camera& camera,
                          const Eigen::Isometry3d& T_world_camera);

// How bright a point of a surface is, as a factor of its colour.
using Lighting = std::function<double(const Polygon& polygon, const Eigen::Vector3d& point_world)>;

// The coloured picture (8-bit BGR) of what the fine camera sees, at half its size.
cv::Mat3b Shade(const VisibleSurfaces& surfaces, const std::vector<Polygon>& polygons,
                const Camera& fine_camera, const Eigen::Isometry3d& T_world_camera, const Lighting& lighting);

}  // namespace armature
