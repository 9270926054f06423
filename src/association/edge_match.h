// SPDX-License-Identifier: BSD-3-Clause
// What association hands on: which segment explains which edge.
#pragma once

#include <vector>

#include "geometry/segment.h"

namespace armature {

// One edge of the wireframe explained by one line segment (an edge may be explained by several collinear
// fragments).
struct EdgeMatch {
  int edge = 0;     // index into the category's edges
  Segment segment;  // pixels, the part inside the detection's grown box
  double cost = 0;  // pixels: rms distance of the segment's ends from the projected edge
};

// How many different edges the matches cover.
int MatchedEdges(const std::vector<EdgeMatch>& matches);

}  // namespace armature
