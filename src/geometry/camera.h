// SPDX-License-Identifier: BSD-3-Clause
// The pinhole camera. Camera frame: x right, y down, z forward; pixel (0,0) is the centre of the top-left
// pixel.
#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/box.h"

namespace armature {

struct Camera {
  int width = 0;                          // pixels
  int height = 0;                         // pixels
  double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels
  std::array<double, 5> distortion{};     // k1 k2 p1 p2 k3 (Brown-Conrady, as OpenCV)

  bool IsDistorted() const;

  // Pixel of a point in the camera frame, without distortion. Requires point.z() > 0.
  Eigen::Vector2d Project(const Eigen::Vector3d& point) const {
    return {fx * point.x() / point.z() + cx, fy * point.y() / point.z() + cy};
  }

  // The point at depth 1 that an undistorted pixel sees.
  Eigen::Vector3d Ray(const Eigen::Vector2d& pixel) const {
    return {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy, 1.0};
  }
};

// The pixel where a distorted pixel would be, had the lens no distortion.
Eigen::Vector2d UndistortPixel(const Camera& camera, const Eigen::Vector2d& pixel);

// The box around the undistorted middles of a distorted box's sides.
Box UndistortBox(const Camera& camera, const Box& box);

}  // namespace armature
