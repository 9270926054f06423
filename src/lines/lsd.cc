// SPDX-License-Identifier: BSD-3-Clause
#include <opencv2/imgproc.hpp>

#include "lines/detectors.h"

namespace armature {
namespace {

class Lsd final : public LineDetector {
 public:
  explicit Lsd(bool published)
      : lsd_(published ? cv::createLineSegmentDetector(cv::LSD_REFINE_STD)
                       // Half the size finds faint edges that noise breaks up; quantisation 1 and density 0.6 keep them.
                       : cv::createLineSegmentDetector(cv::LSD_REFINE_STD, 0.5, 0.6, 1.0, 22.5, 0, 0.6)) {}

  std::vector<Segment> Detect(const cv::Mat& gray) override {
    std::vector<cv::Vec4f> lines;
    lsd_->detect(gray, lines);
    std::vector<Segment> segments;
    segments.reserve(lines.size());
    for (const cv::Vec4f& l : lines) segments.push_back({{l[0], l[1]}, {l[2], l[3]}});
    return segments;
  }

 private:
  cv::Ptr<cv::LineSegmentDetector> lsd_;
};

}  // namespace

std::unique_ptr<LineDetector> MakeLsd(bool published) { return std::make_unique<Lsd>(published); }

}  // namespace armature
