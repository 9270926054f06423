// SPDX-License-Identifier: BSD-3-Clause
// Which segments explain which edges of a projected wireframe, and how much of the wireframe they explain.
//
// An edge and a segment are compared as in the paper (3.3.2): by the perpendicular distances p1, p2 of the
// segment's ends from the projected edge, whose difference stands for the angle (C1) and whose mean for the
// offset (C2). Where the paper adds costs over the edges, we measure coverage: the share of the visible
// projected length that segments explain, weighted by how well they do. A sum of costs would favour
// hypotheses with fewer and smaller edges.
#pragma once

#include <vector>

#include "association/edge_match.h"
#include "association/projection.h"

namespace armature {

struct MatchGate {
  double distance = 4;  // pixels: a segment farther from the edge explains nothing
  double angle = 0.1;   // radians: nor does one turned by more
};

// One pair of edge and segment within the gate.
struct PairScore {
  double overlap = 0;  // pixels: length of the edge's clipped projection beside which the segment runs
  double quality = 0;  // 0..1, 1: on the edge
  double rms = 0;      // pixels, of the segment's ends from the edge's line
};
PairScore ComparePair(const ProjectedEdge& edge, const Segment& segment, const MatchGate& gate);

// Pixels of the visible projected length that segments explain, weighted by quality; a segment may count for
// several edges. The fast measure of the search.
double CoveredLength(const ProjectedWireframe& projected, const std::vector<Segment>& segments,
                     const MatchGate& gate);

struct Matching {
  std::vector<EdgeMatch> matches;
  double covered_length = 0;  // pixels, weighted by quality; every segment counts for one edge only
};

// Gives each segment to the edge that it explains best; an edge may take several fragments.
Matching MatchSegments(const ProjectedWireframe& projected, const std::vector<Segment>& segments,
                       const MatchGate& gate);

}  // namespace armature
