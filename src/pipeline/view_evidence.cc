// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/view_evidence.h"

#include <algorithm>
#include <cmath>

namespace armature {

ViewEvidence CollectViewEvidence(const ObjectView& view, const BoxSides& sides,
                                 const ObjectEstimate& estimate) {
  ViewEvidence evidence;
  evidence.edges = MatchedEdges(estimate.matches);
  evidence.cost = estimate.cost;
  const Eigen::Vector3d t = estimate.T_camera_object.translation();
  const double along_ray = t.dot(estimate.covariance.bottomRightCorner<3, 3>() * t) / t.squaredNorm();
  evidence.depth_sigma = std::sqrt(along_ray) / t.norm();
  for (size_t side = 0; side < 4; ++side) {
    if (view.sides[side] == BoxSide::kOpen) continue;
    if (sides[side] == BoxSide::kOpen) ++evidence.hidden_sides;
    evidence.hideable_sides += view.hidden_probability[side];
  }
  evidence.has_viewpoint = view.detection.azimuth.has_value();
  return evidence;
}

double ComputeProbability(const ViewEvidence& evidence) {
  const double log_odds =
      -1.582 + 0.266 * std::min(evidence.edges, 8) - 1.966 * std::log(std::max(evidence.cost, 0.3)) -
      1.53 * std::log(std::max(evidence.depth_sigma, 0.003)) +
      0.397 * std::sqrt(std::clamp(evidence.margin, 0.0, kMostMargin)) - 0.41 * evidence.hidden_sides +
      0.584 * evidence.hideable_sides - (evidence.has_viewpoint ? 0 : 1.623);
  return 1 / (1 + std::exp(-log_odds));
}

}  // namespace armature
