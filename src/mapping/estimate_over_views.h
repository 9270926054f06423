// SPDX-License-Identifier: BSD-3-Clause
// One object's pose and shape from several images at once, given where the cameras are: the single view's
// search (paper 3.3, Algorithm 1) and resection (3.4), with costs and rows summed over the views. What one
// image leaves open - depth, front and back, which of two turns - the others decide.
#pragma once

#include <utility>
#include <vector>

#include "association/box_constraints.h"
#include "mapping/map_frame.h"
#include "mapping/map_graph.h"
#include "mapping/seen_objects.h"
#include "resection/line_resection.h"

namespace armature {

struct ViewsOfMap {
  const std::vector<MapFrame>& frames;
  const MapGraph& graph;  // where the cameras are, up, and the objects that hide what is behind
  const std::vector<SeenObjects>& seen;  // of the graph, one a frame
  const BoxOptions& box;
  const ResectionOptions& resection;
};

// The object of the graph, of the category's own size, where its views (frame and observation, at least one)
// have it; as it was where they have it nowhere.
GraphObject EstimateOverViews(const ViewsOfMap& map, size_t object,
                              const std::vector<std::pair<size_t, size_t>>& views);

}  // namespace armature
