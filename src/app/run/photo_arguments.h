// SPDX-License-Identifier: BSD-3-Clause
// What `armature photo` is told about a photograph, parsed from texts.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "association/detection.h"
#include "geometry/camera.h"

namespace armature {

// "fx,fy,cx,cy" in pixels, and "k1,k2,p1,p2,k3" or nothing. Throws InputError naming the argument.
Camera ParseCamera(const std::string& intrinsics, const std::string& distortion, int width, int height);

// "category,x,y,width,height[,azimuth_deg]": the box in pixels from the top-left corner, at least partly in
// the image. Throws InputError naming the argument.
Detection ParseDetection(const std::string& text, const Camera& camera,
                         const std::vector<std::string>& categories);

// "x,y,z", a direction in the camera frame (x right, y down, z forward); unit length. Throws InputError.
Eigen::Vector3d ParseUp(const std::string& text);

}  // namespace armature
