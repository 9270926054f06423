// SPDX-License-Identifier: BSD-3-Clause
// A map as a picture (paper, figure 1): the objects as their closest CAD models with the estimated wireframes
// over them, sampled cameras as pink balls, the trajectory as black dots, on a floor with a line every metre.
#pragma once

#include <opencv2/core.hpp>

#include "drawing/map_scene.h"

namespace armature {

struct MapPictureOptions {
  int width = 1600, height = 1000;  // pixels
  int samples = 9;                  // rays a pixel
  bool labels = true;               // the objects' ids
};

// 8-bit BGR, seen as FrameMap says (map_view.h). The same bytes for any number of threads.
cv::Mat DrawMap(const MapScene& scene, const MapPictureOptions& options = {});

}  // namespace armature
