// SPDX-License-Identifier: BSD-3-Clause
// Intrinsics that no camera has, and those that hardly one has.
#pragma once

#include <string>
#include <vector>

#include "geometry/camera.h"

namespace armature {

struct CameraFault {
  std::string key;   // "width", "fx", "cx", "distortion"
  std::string what;  // "is 0.68; ...", with a remedy
  bool is_impossible = false;
};

// Impossible: sizes beyond what image files hold, a focal length that sees more than 168 degrees or less than
// 0.06, pixels five times as wide as high, a principal point more than an image away from the image, a
// distortion that folds inside the image or moves its corners more than threefold. Unusual, though there are
// such cropped and telephoto images: pixels twice as wide as high, a principal point outside the image,
// |k1| > 10.
std::vector<CameraFault> FindCameraFaults(const Camera& camera);

}  // namespace armature
