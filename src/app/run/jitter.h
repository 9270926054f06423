// SPDX-License-Identifier: BSD-3-Clause
// Changes of a run's input that must not matter: far below the errors of any detector.
#pragma once

#include <cstdint>
#include <vector>

#include "association/detection.h"
#include "geometry/camera.h"
#include "geometry/segment.h"

namespace armature {

inline constexpr double kJitterSegmentPixels = 0.1;  // standard deviation of each end, along each axis
inline constexpr double kJitterBoxShare = 0.001;     // of each side, of the box's width or height

// The same for the same seed and image, whatever else is jittered. Boxes stay inside the image.
void JitterBoxes(std::uint64_t seed, size_t image, const Camera& camera, std::vector<Detection>& detections);

// They stay in order, longest first.
void JitterSegments(std::uint64_t seed, size_t image, std::vector<Segment>& segments);

}  // namespace armature
