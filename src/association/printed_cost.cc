// SPDX-License-Identifier: BSD-3-Clause
#include "association/printed_cost.h"

#include <cmath>

namespace armature {

double PrintedPairCost(const Segment& edge, const Segment& segment, const PrintedCostOptions& options,
                       OffsetSign sign) {
  const double p1 = SignedDistanceToLine(edge, segment.p1), p2 = SignedDistanceToLine(edge, segment.p2);
  const double offset = (p1 + p2) / 2;
  return std::abs(p2 - p1) + options.k1 * (sign == OffsetSign::kNone ? std::abs(offset) : offset) +
         options.k2 * (edge.middle() - segment.middle()).norm();
}

PrintedAssociation AssociateAsPrinted(const ProjectedWireframe& projected,
                                      const std::vector<Segment>& segments, const PrintedCostOptions& options,
                                      OffsetSign sign) {
  PrintedAssociation association;
  for (size_t e = 0; e < projected.edges.size(); ++e) {
    if (projected.edges[e].length <= 0) continue;
    EdgeMatch best{static_cast<int>(e), {}, 1e9};
    for (const Segment& segment : segments) {
      const double cost = PrintedPairCost(projected.edges[e].line, segment, options, sign);
      if (cost < best.cost) best = {static_cast<int>(e), segment, cost};
    }
    if (best.cost >= 1e9) continue;
    association.matches.push_back(best);
    association.cost += best.cost;
  }
  return association;
}

}  // namespace armature
