// SPDX-License-Identifier: BSD-3-Clause
#include "lines/line_detector.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lines/detectors.h"

namespace armature {
namespace {

constexpr int kSmallestSide = 16;  // pixels: in smaller regions OpenCV's detectors throw

// Whole-pixel rectangles that hold all grown boxes; those that overlap are merged so that no pixel is
// searched twice.
std::vector<cv::Rect> SearchRegions(const std::vector<Box>& boxes, const cv::Size& size, double margin) {
  const cv::Rect image({0, 0}, size);
  std::vector<cv::Rect> regions;
  for (const Box& box : boxes) {
    const Box grown = box.Grown(margin * std::max(box.width, box.height));
    const cv::Point corner(static_cast<int>(std::floor(grown.left())),
                           static_cast<int>(std::floor(grown.top())));
    const cv::Point opposite(static_cast<int>(std::ceil(grown.right())) + 1,
                             static_cast<int>(std::ceil(grown.bottom())) + 1);
    cv::Rect region = cv::Rect(corner, opposite) & image;
    for (size_t i = 0; i < regions.size();) {
      if ((regions[i] & region).empty()) {
        ++i;
        continue;
      }
      region |= regions[i];  // the larger region may now touch others that were passed: start over
      regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    if (!region.empty()) regions.push_back(region);
  }
  return regions;
}

}  // namespace

std::unique_ptr<LineDetector> MakeLineDetector(const LineOptions& options) {
  switch (options.detector) {
    case LineDetectorKind::kEdgeDrawing:
      return MakeEdgeDrawing(options);
    case LineDetectorKind::kEdLines:
      return MakeEdLines(options);
    case LineDetectorKind::kFld:
      return MakeFld(options);
    case LineDetectorKind::kLsd:
      return MakeLsd(options);
  }
  std::abort();
}

std::vector<Segment> DetectSegments(LineDetector& detector, const cv::Mat& gray, const Camera& camera,
                                    const std::vector<Box>& boxes, const LineOptions& options) {
  std::vector<cv::Rect> regions = {cv::Rect({0, 0}, gray.size())};
  if (options.boxes_only) regions = SearchRegions(boxes, gray.size(), options.box_margin);
  std::vector<Segment> segments;
  for (const cv::Rect& region : regions) {
    if (std::min(region.width, region.height) < kSmallestSide) continue;
    const Eigen::Vector2d offset(region.x, region.y);
    for (const Segment& found : detector.Detect(gray(region))) {
      if (found.length() < options.min_length) continue;
      segments.push_back(
          {UndistortPixel(camera, found.p1 + offset), UndistortPixel(camera, found.p2 + offset)});
    }
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.length() > b.length(); });
  return segments;
}

}  // namespace armature
