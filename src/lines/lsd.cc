// SPDX-License-Identifier: BSD-3-Clause
#include <opencv2/imgproc.hpp>

#include "lines/detectors.h"

namespace armature {
namespace {

constexpr double kPublishedScale = 0.8;
constexpr double kLsdScale = 0.5;  // finds faint edges that noise breaks up
constexpr double kSigmaScale = 0.6;
constexpr double kTunedQuantisation = 1.0, kTunedDensity = 0.6;  // keep the faint edges
constexpr double kAngleTolerance = 22.5;                         // degrees

class Lsd final : public LineDetector {
 public:
  explicit Lsd(bool published)
      : lsd_(published
                 ? cv::createLineSegmentDetector(cv::LSD_REFINE_STD, kPublishedScale)
                 : cv::createLineSegmentDetector(cv::LSD_REFINE_STD, kLsdScale, kSigmaScale,
                                                 kTunedQuantisation, kAngleTolerance, 0, kTunedDensity)),
        offset_((1 / (published ? kPublishedScale : kLsdScale) - 1) / 2) {}

  std::vector<Segment> Detect(const cv::Mat& gray) override {
    std::vector<cv::Vec4f> lines;
    lsd_->detect(gray, lines);
    std::vector<Segment> segments;
    segments.reserve(lines.size());
    const Eigen::Vector2d offset(offset_, offset_);
    for (const cv::Vec4f& l : lines) {
      segments.push_back({Eigen::Vector2d(l[0], l[1]) + offset, Eigen::Vector2d(l[2], l[3]) + offset});
    }
    return segments;
  }

 private:
  cv::Ptr<cv::LineSegmentDetector> lsd_;
  // Pixels. OpenCV divides positions in the scaled image by the scale, as if the first pixels' centres
  // coincided; it is the images' corners that do, so that both coordinates come out too small.
  double offset_;
};

}  // namespace

std::unique_ptr<LineDetector> MakeLsd(const LineOptions& options) {
  return std::make_unique<Lsd>(options.published);
}

}  // namespace armature
