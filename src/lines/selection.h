// SPDX-License-Identifier: BSD-3-Clause
// Which of an image's segments may belong to an object.
#pragma once

#include <vector>

#include "geometry/box.h"
#include "geometry/segment.h"

namespace armature {

// The parts of the segments inside the box, those of at least min_length pixels, the longest first, at most
// max_count.
std::vector<Segment> SegmentsInBox(const std::vector<Segment>& segments, const Box& box, double min_length,
                                   int max_count);

}  // namespace armature
