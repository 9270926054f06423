// SPDX-License-Identifier: BSD-3-Clause
#include "association/matching.h"

#include <algorithm>
#include <cmath>

namespace armature {
namespace {

constexpr double kMinVisibleShare = 0.2;  // an edge of which less is seen is not looked for
constexpr double kMinOverlap = 0.3;       // share of the segment that must run beside the edge

bool IsLookedFor(const ProjectedEdge& edge) {
  return edge.length > 1 && edge.visible_share >= kMinVisibleShare;
}

}  // namespace

PairScore ComparePair(const ProjectedEdge& edge, const Segment& segment, const MatchGate& gate) {
  const Eigen::Vector2d &d = edge.direction, a = segment.p1 - edge.line.p1, b = segment.p2 - edge.line.p1;
  const double p1 = d.x() * a.y() - d.y() * a.x(), p2 = d.x() * b.y() - d.y() * b.x();
  const double offset = std::abs(p1 + p2) / 2;
  const double distance = gate.distance + edge.slack;
  if (offset > distance) return {};
  double t1 = d.dot(a), t2 = d.dot(b);
  if (t1 > t2) std::swap(t1, t2);
  const double overlap = std::min(t2, edge.length) - std::max(t1, 0.0);
  if (overlap <= 0) return {};
  const double run = t2 - t1, rise = std::abs(p2 - p1);
  const double slope = rise / (run * gate.angle);  // tan of the angle, in units of the gate
  if (slope > 1 || overlap < kMinOverlap * run) return {};
  const double rms = std::sqrt((p1 * p1 + p2 * p2) / 2);
  const double reach = offset / distance;
  return {overlap, (1 - reach * reach) * (1 - slope * slope), rms};
}

double CoveredLength(const ProjectedWireframe& projected, const std::vector<Segment>& segments,
                     const MatchGate& gate) {
  double sum = 0;
  for (const ProjectedEdge& edge : projected.edges) {
    if (!IsLookedFor(edge)) continue;
    double covered = 0;
    for (const Segment& segment : segments) {
      const PairScore pair = ComparePair(edge, segment, gate);
      covered += pair.overlap * pair.quality;
    }
    sum += std::min(covered, edge.length * edge.visible_share);
  }
  return sum;
}

Matching MatchSegments(const ProjectedWireframe& projected, const std::vector<Segment>& segments,
                       const MatchGate& gate) {
  Matching matching;
  std::vector<double> covered(projected.edges.size(), 0);
  for (const Segment& segment : segments) {
    int best_edge = -1;
    PairScore best;
    for (size_t e = 0; e < projected.edges.size(); ++e) {
      if (!IsLookedFor(projected.edges[e])) continue;
      const PairScore pair = ComparePair(projected.edges[e], segment, gate);
      if (pair.overlap * pair.quality > best.overlap * best.quality) {
        best = pair;
        best_edge = static_cast<int>(e);
      }
    }
    if (best_edge < 0) continue;
    matching.matches.push_back({best_edge, segment, best.rms});
    covered[static_cast<size_t>(best_edge)] += best.overlap * best.quality;
  }
  for (size_t e = 0; e < covered.size(); ++e) {
    const ProjectedEdge& edge = projected.edges[e];
    matching.covered_length += std::min(covered[e], edge.length * edge.visible_share);
  }
  return matching;
}

}  // namespace armature
