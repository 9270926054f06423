// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <opencv2/line_descriptor.hpp>

#include "lines/detectors.h"

namespace armature {
namespace {

using cv::line_descriptor::BinaryDescriptor;
using cv::line_descriptor::KeyLine;

// OpenCV prints to standard output when there are no lines; that would end up in the middle of a table.
class QuietOutput {
 public:
  QuietOutput() : buffer_(std::cout.rdbuf(nullptr)) {}
  ~QuietOutput() { std::cout.rdbuf(buffer_); }
  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;

 private:
  std::streambuf* buffer_;
};

// The detector inside OpenCV's BinaryDescriptor, on one octave. It has no thresholds to set: a lighter blur
// is all that recall can be tuned by.
class EdLines final : public LineDetector {
 public:
  explicit EdLines(bool published) {
    BinaryDescriptor::Params params;
    params.numOfOctave_ = 1;
    params.ksize_ = published ? 5 : 3;
    detector_ = BinaryDescriptor::createBinaryDescriptor(params);
  }

  std::vector<Segment> Detect(const cv::Mat& gray) override {
    std::vector<KeyLine> lines;
    {
      const QuietOutput quiet;
      detector_->detect(gray, lines);
    }
    std::vector<Segment> segments;
    segments.reserve(lines.size());
    for (const KeyLine& l : lines) {
      segments.push_back({{l.startPointX, l.startPointY}, {l.endPointX, l.endPointY}});
    }
    return segments;
  }

 private:
  cv::Ptr<BinaryDescriptor> detector_;
};

}  // namespace

std::unique_ptr<LineDetector> MakeEdLines(const LineOptions& options) {
  return std::make_unique<EdLines>(options.published);
}

}  // namespace armature
