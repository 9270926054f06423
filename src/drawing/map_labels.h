// SPDX-License-Identifier: BSD-3-Clause
// The objects' ids in a picture of a map.
#pragma once

#include <opencv2/core.hpp>

#include "drawing/map_view.h"

namespace armature {

// Above each object; none over another.
void DrawMapLabels(const MapScene& scene, const MapView& view, cv::Mat3b* picture);

}  // namespace armature
