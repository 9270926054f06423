// SPDX-License-Identifier: BSD-3-Clause
// What an object detector and a viewpoint estimator say about one object in one image.
#pragma once

#include <optional>
#include <string>

#include "geometry/box.h"
#include "geometry/viewpoint.h"

namespace armature {

struct Detection {
  std::string category;
  Box box;                          // pixels, the object's visible extent
  double score = 1;                 // 0..1
  std::optional<double> azimuth;    // radians, see geometry/viewpoint.h
  std::optional<double> elevation;  // radians
  std::optional<double> tilt;       // radians
};

}  // namespace armature
