// SPDX-License-Identifier: BSD-3-Clause
// Line segment detectors. One pass over an image serves all of its objects.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "base/enum_names.h"
#include "geometry/box.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

enum class LineDetectorKind { kEdgeDrawing, kEdLines, kFld, kLsd };

template <>
struct EnumNames<LineDetectorKind> {
  static constexpr NamedValue<LineDetectorKind> kTable[] = {{LineDetectorKind::kEdgeDrawing, "edgedrawing"},
                                                            {LineDetectorKind::kEdLines, "edlines"},
                                                            {LineDetectorKind::kFld, "fld"},
                                                            {LineDetectorKind::kLsd, "lsd"}};
};

struct LineOptions {
  LineDetectorKind detector = LineDetectorKind::kEdgeDrawing;
  bool published = false;          // the detector's published parameters instead of those tuned for recall
  double edgedrawing_scale = 0.7;  // of the image that the tuned edgedrawing looks at, 1: as it is
  double min_length = 10;          // pixels, shorter segments are dropped
  bool boxes_only = false;   // look only inside the grown boxes of the detections, not at the whole image
  double box_margin = 0.06;  // a box is grown by this share of its larger side, each side
};

// A detector of straight image edges. Not thread-safe: one a thread.
class LineDetector {
 public:
  virtual ~LineDetector() = default;
  // `gray`: 8 bit, one channel. Ends in pixels of that image, in no particular order, (0,0) the centre of its
  // first pixel.
  virtual std::vector<Segment> Detect(const cv::Mat& gray) = 0;
};

std::unique_ptr<LineDetector> MakeLineDetector(const LineOptions& options);

// Detects in the whole image, or in the bounding rectangles of overlapping grown boxes, drops short segments
// and takes the lens distortion out of the ends. Result: undistorted pixels, longest first. Regions under 16
// pixels have none.
std::vector<Segment> DetectSegments(LineDetector& detector, const cv::Mat& gray, const Camera& camera,
                                    const std::vector<Box>& boxes, const LineOptions& options);

}  // namespace armature
