// SPDX-License-Identifier: BSD-3-Clause
// Which object an observation is of: the paper's phi.
//
// The front end strings observations together over the last seconds (tracks). Here, with all frames at hand:
// tracks of one object become one object, also where the camera comes back to it after a loop (object loop
// closure, OLC). What no track is asked for is searched for by all detections (object_search.h).
#pragma once

#include <optional>
#include <vector>

#include "geometry/oriented_box.h"
#include "mapping/map_frame.h"
#include "mapping/map_graph.h"

namespace armature {

struct ObjectAssociationOptions {
  double gate = 4;            // squared Mahalanobis distance per row that joins two objects
  double drift = 0.05;        // metres a metre travelled: of the odometry since an object was last seen
  double turn_drift_deg = 1;  // degrees a metre travelled
};

struct Merge {
  int kept = 0, joined = 0;  // objects
  double turn = 0;       // radians: the joined object's own front is turned by this against the kept one's
  bool flipped = false;  // fronts disagree though neither is symmetric
};

// The next two objects of the graph to be joined; none when no two are one. That is the pair that agrees best
// of those without rivals. A rival cannot be true as well: after a loop, a chair may be either of two that
// were seen together. Where every pair has rivals, the best pair and its rivals; which one it is, the
// odometry may tell. `seconds_between` limits it to pairs seen within that time of each other (without loop
// closure); none: no limit.
std::vector<Merge> FindMerges(const MapGraph& graph, const std::vector<MapFrame>& frames,
                              std::optional<double> seconds_between, const ObjectAssociationOptions& options);

// Around the object's edges.
OrientedBox MakeBox(const GraphObject& object);

// Makes one object of two: observations, factors, phi; later objects move up.
void ApplyMerge(const Merge& merge, MapGraph& graph, ObjectOfObservation& phi);

// Takes objects without any observation out of graph and phi; later objects move up.
void DropUnseen(MapGraph& graph, ObjectOfObservation& phi);

// First and last time at which an object is seen, seconds.
struct TimeSpan {
  double first = 1e18, last = -1e18;
};

// Of each object, as phi has it.
std::vector<TimeSpan> SeenSpans(size_t objects, const std::vector<MapFrame>& frames,
                                const ObjectOfObservation& phi);

// Each detection of the frame to the object whose projection fits its box best, one-to-one; -1: to none.
// Objects are candidates within `seconds_between` of their spans.
std::vector<int> AssociateFrame(const std::vector<GraphObject>& objects, const std::vector<TimeSpan>& spans,
                                const PassedFrame& frame, const Eigen::Isometry3d& T_world_camera,
                                std::optional<double> seconds_between);

}  // namespace armature
