// SPDX-License-Identifier: BSD-3-Clause
#include <opencv2/ximgproc/edge_drawing.hpp>

#include "lines/detectors.h"

namespace armature {
namespace {

class EdgeDrawing final : public LineDetector {
 public:
  explicit EdgeDrawing(bool published) : detector_(cv::ximgproc::createEdgeDrawing()) {
    if (published) return;
    // Low thresholds: furniture against a wall is often a faint edge; the clutter that comes with it costs less than a
    // missing edge.
    detector_->params.EdgeDetectionOperator = cv::ximgproc::EdgeDrawing::PREWITT;
    detector_->params.GradientThresholdValue = 12;
    detector_->params.AnchorThresholdValue = 4;
  }

  std::vector<Segment> Detect(const cv::Mat& gray) override {
    std::vector<cv::Vec4f> lines;
    detector_->detectEdges(gray);
    detector_->detectLines(lines);
    std::vector<Segment> segments;
    segments.reserve(lines.size());
    for (const cv::Vec4f& l : lines) segments.push_back({{l[0], l[1]}, {l[2], l[3]}});
    return segments;
  }

 private:
  cv::Ptr<cv::ximgproc::EdgeDrawing> detector_;
};

}  // namespace

std::unique_ptr<LineDetector> MakeEdgeDrawing(bool published) { return std::make_unique<EdgeDrawing>(published); }

}  // namespace armature
