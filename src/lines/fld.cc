// SPDX-License-Identifier: BSD-3-Clause
#include <opencv2/ximgproc/fast_line_detector.hpp>

#include "lines/detectors.h"

namespace armature {
namespace {

class Fld final : public LineDetector {
 public:
  explicit Fld(bool published)
      : detector_(published ? cv::ximgproc::createFastLineDetector()
                            : cv::ximgproc::createFastLineDetector(10, 1.414f, 15, 40, 3, false)) {}

  std::vector<Segment> Detect(const cv::Mat& gray) override {
    std::vector<cv::Vec4f> lines;
    detector_->detect(gray, lines);
    std::vector<Segment> segments;
    segments.reserve(lines.size());
    for (const cv::Vec4f& l : lines) segments.push_back({{l[0], l[1]}, {l[2], l[3]}});
    return segments;
  }

 private:
  cv::Ptr<cv::ximgproc::FastLineDetector> detector_;
};

}  // namespace

std::unique_ptr<LineDetector> MakeFld(const LineOptions& options) {
  return std::make_unique<Fld>(options.published);
}

}  // namespace armature
