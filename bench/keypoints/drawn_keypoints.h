// SPDX-License-Identifier: BSD-3-Clause
// Keypoints as a trained network might see them: not known from the image but made up, without ground truth,
// so that what follows a network has work of plausible difficulty to do.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "association/object_view.h"
#include "geometry/random.h"
#include "resection/resection_problem.h"

namespace armature {

// Where the lens moves the undistorted pixel to: the inverse of UndistortPixel.
Eigen::Vector2d DistortPixel(const Camera& camera, const Eigen::Vector2d& pixel);

// Pixels, in the image as it is, of the keypoints of the category's mean shape, placed by the box and turned
// by about 10 degrees from the detection's azimuth, as viewpoint priors are off; 1.5 pixels of noise on each
// coordinate. A keypoint behind the camera is far outside of the image.
std::vector<Eigen::Vector2d> DrawnKeypoints(const ObjectView& view, const std::vector<ShapePoint>& keypoints,
                                            Random& random);

}  // namespace armature
