// SPDX-License-Identifier: BSD-3-Clause
// What a detector does to the box of one object.
#pragma once

#include <array>
#include <vector>

#include "datasets/simulation/detection_noise.h"
#include "datasets/simulation/lasting_error.h"
#include "datasets/simulation/stretches.h"
#include "geometry/box.h"
#include "geometry/camera.h"
#include "geometry/random.h"

namespace armature {

inline constexpr double kLeastBox = 4;  // pixels each way, after all errors: less is no detection

bool IsBox(const Box& box);

// All pixels.
Box ImageBox(const Camera& camera);

// The smallest box around both.
Box Union(const Box& a, const Box& b);

// Sides that are off, partly for a while. Keeps random numbers of its own for what stays.
class BoxErrors {
 public:
  explicit BoxErrors(std::uint64_t seed) : random_(seed) {}

  // The box with its errors, inside the image. `frame`: what is drawn for this frame alone.
  Box Apply(const Box& box, const DetectionNoise& noise, double time, const Camera& camera, Random& frame);

 private:
  Random random_;
  std::array<LastingError, 4> sides_;
};

// Boxes around a part of what is seen: for stretches, of which each has a side of its own that is cut.
class PartBoxes {
 public:
  explicit PartBoxes(std::uint64_t seed) : random_(seed) {}

  Box Apply(const Box& box, double visible_share, const DetectionNoise& noise, double time);

 private:
  Random random_;
  Stretches stretches_;
  int side_ = 0;     // left, right, top, bottom
  double kept_ = 1;  // share of the width or height
};

}  // namespace armature
