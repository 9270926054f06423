// SPDX-License-Identifier: BSD-3-Clause
#include "lines/selection.h"

#include <algorithm>

namespace armature {

std::vector<Segment> SegmentsInBox(const std::vector<Segment>& segments, const Box& box, double min_length,
                                   int max_count) {
  std::vector<Segment> inside;
  for (const Segment& segment : segments) {
    const std::optional<Segment> part = Clipped(segment, box);
    if (part && part->length() >= min_length) inside.push_back(*part);
  }
  // The longest first: a clipped segment may have lost its place.
  std::stable_sort(inside.begin(), inside.end(),
                   [](const Segment& a, const Segment& b) { return a.length() > b.length(); });
  if (inside.size() > static_cast<size_t>(max_count)) inside.resize(static_cast<size_t>(max_count));
  return inside;
}

}  // namespace armature
