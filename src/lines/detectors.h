// SPDX-License-Identifier: BSD-3-Clause
// The makers behind MakeLineDetector, one file a detector. `published`: the published parameters, else tuned
// for recall.
#pragma once

#include <memory>

#include "lines/line_detector.h"

namespace armature {

// EDLines on Edge Drawing (Akinlar & Topal 2011/2012), OpenCV ximgproc.
std::unique_ptr<LineDetector> MakeEdgeDrawing(bool published);
// EDLines as in OpenCV's line_descriptor (Zhang & Koch 2013).
std::unique_ptr<LineDetector> MakeEdLines(bool published);
// Fast Line Detector (Lee et al. 2014), OpenCV ximgproc.
std::unique_ptr<LineDetector> MakeFld(bool published);
// LSD (von Gioi et al. 2012), OpenCV imgproc.
std::unique_ptr<LineDetector> MakeLsd(bool published);

}  // namespace armature
