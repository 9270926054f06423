// SPDX-License-Identifier: BSD-3-Clause
// The makers behind MakeLineDetector, one file a detector. Of the options only those are used that say how
// the detector is set: published or tuned for recall.
#pragma once

#include <memory>

#include "lines/line_detector.h"

namespace armature {

// EDLines on Edge Drawing (Akinlar & Topal 2011/2012), OpenCV ximgproc.
std::unique_ptr<LineDetector> MakeEdgeDrawing(const LineOptions& options);
// EDLines as in OpenCV's line_descriptor (Zhang & Koch 2013).
std::unique_ptr<LineDetector> MakeEdLines(const LineOptions& options);
// Fast Line Detector (Lee et al. 2014), OpenCV ximgproc.
std::unique_ptr<LineDetector> MakeFld(const LineOptions& options);
// LSD (von Gioi et al. 2012), OpenCV imgproc.
std::unique_ptr<LineDetector> MakeLsd(const LineOptions& options);

}  // namespace armature
