// SPDX-License-Identifier: BSD-3-Clause
// The matches of one detection against its object's true edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "geometry/segment.h"
#include "truth/visible_edges.h"

namespace armature {

// An edge counts as visible from this visible length, and from this share of its part in the image where only
// the share is known: what is hidden elsewhere cannot be told from what is seen.
constexpr double kLeastVisiblePixels = 20;
constexpr double kLeastVisibleShare = 0.3;

bool IsVisible(const VisibleEdge& edge);

// How near a match has to be to be right. Edges are annotated along the axes of legs and posts, whose
// outlines are some centimetres beside them: the second tolerance allows for that.
inline constexpr EdgeTolerance kOnEdge{.distance = 4, .metres = 0, .angle_deg = 6};
inline constexpr EdgeTolerance kNearEdge{.distance = 4, .metres = 0.05, .angle_deg = 6};

struct RightMatches {
  int matches =
      0;          // rows of associations.csv that lie on the edge they name, under the nearest symmetric turn
  int edges = 0;  // visible true edges with such a match
  double match_length = 0;    // pixels: of those rows' segments
  double covered_length = 0;  // pixels of the visible true edges' visible length beside which they run
};

// Sums over one detection, or many.
struct MatchCounts {
  int matches = 0;            // rows of associations.csv
  int visible_edges = 0;      // true edges that are visible
  double match_length = 0;    // pixels: of the rows' segments
  double visible_length = 0;  // pixels: of the visible edges
  RightMatches on_edge;       // by kOnEdge
  RightMatches near_edge;     // by kNearEdge

  MatchCounts& operator+=(const MatchCounts& more);
};

// A row of associations.csv.
struct NamedSegment {
  size_t edge = 0;  // of the category, as the run names it
  Segment segment;  // undistorted pixels
};

// The same against the truth.
struct JudgedMatch {
  std::string edge;                // as the run names it
  std::string true_edge;           // the one that stands there, under the nearest symmetric turn
  bool on_edge = false;            // right by kOnEdge
  bool near_edge = false;          // right by kNearEdge
  std::optional<double> distance;  // pixels: see DistanceFromLine; none: the true edge is outside the image
  double length = 0;               // pixels: of the segment
};

struct JudgedMatches {
  MatchCounts counts;
  std::vector<JudgedMatch> rows;  // in the order of the matches
};

// `edges`: the true ones, in the order of the category. `named[e]`: the one of them that the estimate calls
// e.
JudgedMatches JudgeMatches(const std::vector<NamedSegment>& matches, const CategorySpec& spec,
                           const std::vector<VisibleEdge>& edges, const std::vector<int>& named);

}  // namespace armature
