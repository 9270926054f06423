// SPDX-License-Identifier: BSD-3-Clause
#include "eval/edges/edge_matches.h"

namespace armature {
namespace {

void Add(const RightMatches& more, RightMatches& sum) {
  sum.matches += more.matches;
  sum.edges += more.edges;
  sum.match_length += more.match_length;
  sum.covered_length += more.covered_length;
}

// `edge_of[i]`: the true edge that match i means.
RightMatches CountRight(const std::vector<NamedSegment>& matches, const std::vector<size_t>& edge_of,
                        const std::vector<VisibleEdge>& edges, const EdgeTolerance& tolerance) {
  RightMatches right;
  std::vector<std::vector<Segment>> segments_of(edges.size());
  for (size_t i = 0; i < matches.size(); ++i) {
    if (!LiesOnEdge(matches[i].segment, edges[edge_of[i]], tolerance)) continue;
    ++right.matches;
    right.match_length += matches[i].segment.length();
    segments_of[edge_of[i]].push_back(matches[i].segment);
  }
  for (size_t e = 0; e < edges.size(); ++e) {
    if (segments_of[e].empty() || !IsVisible(edges[e])) continue;
    ++right.edges;
    right.covered_length += CoveredLength(edges[e], segments_of[e], tolerance);
  }
  return right;
}

MatchCounts Count(const std::vector<NamedSegment>& matches, const std::vector<size_t>& edge_of,
                  const std::vector<VisibleEdge>& edges) {
  MatchCounts counts;
  counts.matches = static_cast<int>(matches.size());
  for (const NamedSegment& match : matches) counts.match_length += match.segment.length();
  for (const VisibleEdge& edge : edges) {
    if (!IsVisible(edge)) continue;
    ++counts.visible_edges;
    counts.visible_length += edge.visible_length();
  }
  counts.on_edge = CountRight(matches, edge_of, edges, kOnEdge);
  counts.near_edge = CountRight(matches, edge_of, edges, kNearEdge);
  return counts;
}

JudgedMatch Judge(const Segment& segment, const VisibleEdge& edge) {
  JudgedMatch row;
  row.on_edge = LiesOnEdge(segment, edge, kOnEdge);
  row.near_edge = LiesOnEdge(segment, edge, kNearEdge);
  if (edge.in_image) row.distance = DistanceFromLine(segment, edge);
  row.length = segment.length();
  return row;
}

}  // namespace

bool IsVisible(const VisibleEdge& edge) {
  return edge.visible_length() >= kLeastVisiblePixels && edge.visible_share >= kLeastVisibleShare;
}

MatchCounts& MatchCounts::operator+=(const MatchCounts& more) {
  matches += more.matches;
  visible_edges += more.visible_edges;
  match_length += more.match_length;
  visible_length += more.visible_length;
  Add(more.on_edge, on_edge);
  Add(more.near_edge, near_edge);
  return *this;
}

JudgedMatches JudgeMatches(const std::vector<NamedSegment>& matches, const CategorySpec& spec,
                           const std::vector<VisibleEdge>& edges, const std::vector<int>& named) {
  JudgedMatches judged;
  std::vector<size_t> edge_of;
  for (const NamedSegment& match : matches) {
    edge_of.push_back(static_cast<size_t>(named[match.edge]));
    JudgedMatch row = Judge(match.segment, edges[edge_of.back()]);
    row.edge = spec.edge_names[match.edge];
    row.true_edge = spec.edge_names[edge_of.back()];
    judged.rows.push_back(std::move(row));
  }
  judged.counts = Count(matches, edge_of, edges);
  return judged;
}

}  // namespace armature
