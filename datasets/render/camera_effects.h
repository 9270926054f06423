// SPDX-License-Identifier: BSD-3-Clause
// What a real camera adds to a picture.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace armature {

struct CameraEffects {
  double blur_px = 0.5;           // sigma of the lens, pixels
  double motion_blur_px = 0.5;    // mean length of the motion during an exposure, pixels
  double noise = 2.0;             // sigma of mid grey, grey levels of 255
  double exposure_change = 0.06;  // sigma of the exposure's slow change over the frames, share
  double vignetting = 0.15;       // share of the light that is lost in the corners
  double exposure = 1;            // 1: well exposed, less: darker
};

// The 8-bit BGR picture of linear radiance: exposure, vignetting, blur, tone curve, noise. The same for the
// same seed and frame.
cv::Mat3b Develop(const cv::Mat3f& radiance, const CameraEffects& effects, std::uint64_t seed, int frame);

}  // namespace armature
