// SPDX-License-Identifier: BSD-3-Clause
#include "association/matching.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace armature {
namespace {

constexpr double kMinVisibleShare = 0.2;  // an edge of which less is seen is not looked for
constexpr double kMinOverlap = 0.3;       // share of the segment that must run beside the edge

bool IsLookedFor(const ProjectedEdge& edge) {
  return edge.length > 1 && edge.visible_share >= kMinVisibleShare;
}

// The middles of all segments. Most pairs fail because the segment is too far beside the edge, and its middle
// decides that: for all segments at once, in a loop that the compiler vectorises.
class Middles {
 public:
  explicit Middles(const std::vector<Segment>& segments)
      : x_(static_cast<Eigen::Index>(segments.size())), y_(x_.size()), offset_(x_.size()) {
    for (size_t i = 0; i < segments.size(); ++i) {
      const Segment& segment = segments[i];
      x_(static_cast<Eigen::Index>(i)) = 0.5 * (segment.p1.x() + segment.p2.x());
      y_(static_cast<Eigen::Index>(i)) = 0.5 * (segment.p1.y() + segment.p2.y());
    }
  }

  // Calls `near` with the index of each segment that is beside the edge's line.
  template <typename Near>
  void ForEachBeside(const ProjectedEdge& edge, const MatchGate& gate, const Near& near) {
    constexpr double kRounding = 1e-6;  // pixels: ComparePair decides
    const Eigen::Vector2d &d = edge.direction, &p = edge.line.p1;
    const double reach = gate.distance + edge.slack + kRounding;
    offset_ = (d.x() * (y_ - p.y()) - d.y() * (x_ - p.x())).abs();
    for (Eigen::Index i = 0; i < offset_.size(); ++i) {
      if (offset_(i) <= reach) near(static_cast<size_t>(i));
    }
  }

 private:
  Eigen::ArrayXd x_, y_, offset_;  // pixels
};

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
  Middles middles(segments);
  double sum = 0;
  for (const ProjectedEdge& edge : projected.edges) {
    if (!IsLookedFor(edge)) continue;
    double covered = 0;
    middles.ForEachBeside(edge, gate, [&](size_t i) {
      const PairScore pair = ComparePair(edge, segments[i], gate);
      covered += pair.overlap * pair.quality;
    });
    sum += std::min(covered, edge.length * edge.visible_share);
  }
  return sum;
}

Matching MatchSegments(const ProjectedWireframe& projected, const std::vector<Segment>& segments,
                       const MatchGate& gate) {
  struct Best {
    int edge = -1;
    PairScore pair;
    double explained() const { return pair.overlap * pair.quality; }
  };
  Middles middles(segments);
  std::vector<Best> best(segments.size());
  for (size_t e = 0; e < projected.edges.size(); ++e) {
    const ProjectedEdge& edge = projected.edges[e];
    if (!IsLookedFor(edge)) continue;
    middles.ForEachBeside(edge, gate, [&](size_t i) {
      const Best candidate{static_cast<int>(e), ComparePair(edge, segments[i], gate)};
      if (candidate.explained() > best[i].explained()) best[i] = candidate;
    });
  }
  Matching matching;
  std::vector<double> covered(projected.edges.size(), 0);
  for (size_t i = 0; i < segments.size(); ++i) {
    if (best[i].edge < 0) continue;
    matching.matches.push_back({best[i].edge, segments[i], best[i].pair.rms});
    covered[static_cast<size_t>(best[i].edge)] += best[i].explained();
  }
  for (size_t e = 0; e < covered.size(); ++e) {
    const ProjectedEdge& edge = projected.edges[e];
    matching.covered_length += std::min(covered[e], edge.length * edge.visible_share);
  }
  return matching;
}

int MatchedEdges(const std::vector<EdgeMatch>& matches) {
  std::set<int> edges;
  for (const EdgeMatch& match : matches) edges.insert(match.edge);
  return static_cast<int>(edges.size());
}

}  // namespace armature
