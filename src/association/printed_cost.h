// SPDX-License-Identifier: BSD-3-Clause
// The association cost exactly as the paper prints it (3.3.2, eqs. 6 and 10-15).
#pragma once

#include <vector>

#include "association/matching.h"

namespace armature {

struct PrintedCostOptions {
  double k1 = 1;    // weight of C2
  double k2 = 0.1;  // weight of C3
};

// C = C1 + k1 C2 + k2 C3 of one pair: C1 = |p2 - p1|, C2 = (p1 + p2) / 2 (signed, as printed), C3 = distance
// between the middles; pixels. The edge counts with its whole projection, seen or not.
double PrintedPairCost(const Segment& edge, const Segment& segment, const PrintedCostOptions& options);

// Every edge takes the segment that costs least; the costs are added up. An edge behind the camera takes
// none.
struct PrintedAssociation {
  std::vector<EdgeMatch> matches;
  double cost = 0;
};
PrintedAssociation AssociateAsPrinted(const ProjectedWireframe& projected,
                                      const std::vector<Segment>& segments,
                                      const PrintedCostOptions& options);

}  // namespace armature
