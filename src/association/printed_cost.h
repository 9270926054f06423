// SPDX-License-Identifier: BSD-3-Clause
// The paper's association cost (3.3.2, eqs. 6 and 10-15): exactly as printed, or as it must be meant.
//
// Read alike in both: eq. 14's M is the middle of the edge's projection; every edge takes the segment that
// costs it least (3.3.3), seen or not and whoever else has it, for the paper's map from edges to segments
// need not be one-to-one; k1 and k2, of which nothing is printed, are options.
#pragma once

#include <vector>

#include "association/matching.h"

namespace armature {

enum class OffsetSign {
  kPrinted,  // eq. 13: a segment on one side of the edge costs less than one on it, one that crosses nothing
  kNone,     // |p1 + p2| / 2, the "perpendicular distance of the midpoint" that the text has it capture
};

struct PrintedCostOptions {
  double k1 = 1;    // weight of C2
  double k2 = 0.1;  // weight of C3
};

// C = C1 + k1 C2 + k2 C3 of one pair: C1 = |p2 - p1|, C2 = (p1 + p2) / 2 with its sign or without, C3 =
// distance between the middles; pixels. The edge counts with its whole projection, seen or not.
double PrintedPairCost(const Segment& edge, const Segment& segment, const PrintedCostOptions& options,
                       OffsetSign sign);

// Every edge takes the segment that costs least; the costs are added up. An edge behind the camera takes
// none.
struct PrintedAssociation {
  std::vector<EdgeMatch> matches;
  double cost = 0;
};
PrintedAssociation AssociateAsPrinted(const ProjectedWireframe& projected,
                                      const std::vector<Segment>& segments, const PrintedCostOptions& options,
                                      OffsetSign sign);

}  // namespace armature
