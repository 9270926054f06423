// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/box_errors.h"

#include <algorithm>
#include <cmath>

namespace armature {

bool IsBox(const Box& box) { return box.width >= kLeastBox && box.height >= kLeastBox; }

Box ImageBox(const Camera& camera) {
  return {-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
}

Box Union(const Box& a, const Box& b) {
  const double left = std::min(a.left(), b.left()), top = std::min(a.top(), b.top());
  return {left, top, std::max(a.right(), b.right()) - left, std::max(a.bottom(), b.bottom()) - top};
}

Box BoxErrors::Apply(const Box& box, const DetectionNoise& noise, double time, const Camera& camera,
                     Random& frame) {
  const double fresh = noise.box * std::sqrt(1 - noise.box_lasting);
  const double lasting = noise.box * std::sqrt(noise.box_lasting);
  std::array<double, 4> stays;
  for (size_t i = 0; i < stays.size(); ++i)
    stays[i] = lasting * sides_[i].At(time, noise.box_seconds, random_);
  const double left = frame.Normal(box.left(), fresh * box.width) + stays[0] * box.width;
  const double right = frame.Normal(box.right(), fresh * box.width) + stays[1] * box.width;
  const double top = frame.Normal(box.top(), fresh * box.height) + stays[2] * box.height;
  const double bottom = frame.Normal(box.bottom(), fresh * box.height) + stays[3] * box.height;
  return Intersection({left, top, right - left, bottom - top}, ImageBox(camera));
}

Box PartBoxes::Apply(const Box& box, double visible_share, const DetectionNoise& noise, double time) {
  constexpr double kLeastKept = 0.4, kMostKept = 0.8;  // of a side, so that most parts are taken for false
  const bool is_part = stretches_.IsOn(noise.part * (1 - visible_share), noise.part_seconds, time, random_);
  if (stretches_.has_begun()) {
    side_ = static_cast<int>(random_.Uniform(0, 4));
    kept_ = random_.Uniform(kLeastKept, kMostKept);
  }
  if (!is_part) return box;
  const double lost = (1 - kept_) * (side_ < 2 ? box.width : box.height);
  switch (side_) {
    case 0:
      return {box.x + lost, box.y, box.width - lost, box.height};
    case 1:
      return {box.x, box.y, box.width - lost, box.height};
    case 2:
      return {box.x, box.y + lost, box.width, box.height - lost};
    default:
      return {box.x, box.y, box.width, box.height - lost};
  }
}

}  // namespace armature
