// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/jitter.h"

#include <algorithm>

#include "geometry/random.h"

namespace armature {
namespace {

// Boxes and segments of an image have streams of their own.
Random JitterOf(std::uint64_t seed, size_t image, std::uint64_t kind) {
  return Random(StreamSeed(StreamSeed(seed, image), kind));
}

}  // namespace

void JitterBoxes(std::uint64_t seed, size_t image, const Camera& camera, std::vector<Detection>& detections) {
  Random random = JitterOf(seed, image, 0);
  for (Detection& detection : detections) {
    const Box box = detection.box;
    const double x_sigma = kJitterBoxShare * box.width, y_sigma = kJitterBoxShare * box.height;
    const double left = std::clamp(random.Normal(box.left(), x_sigma), 0.0, box.left() + box.width / 2);
    const double top = std::clamp(random.Normal(box.top(), y_sigma), 0.0, box.top() + box.height / 2);
    const double right = std::min(random.Normal(box.right(), x_sigma), static_cast<double>(camera.width));
    const double bottom = std::min(random.Normal(box.bottom(), y_sigma), static_cast<double>(camera.height));
    detection.box = {left, top, right - left, bottom - top};
  }
}

void JitterSegments(std::uint64_t seed, size_t image, std::vector<Segment>& segments) {
  Random random = JitterOf(seed, image, 1);
  for (Segment& segment : segments) {
    for (Eigen::Vector2d* end : {&segment.p1, &segment.p2}) {
      for (double& coordinate : *end) coordinate = random.Normal(coordinate, kJitterSegmentPixels);
    }
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.length() > b.length(); });
}

}  // namespace armature
