// SPDX-License-Identifier: BSD-3-Clause
// Objects from the detections of all frames at once, given where the cameras are, and the scale at which they
// explain most.
//
// Needs no tracks, which a front end that does not know the scale loses and mixes. What one view shows,
// nearer or farther than that view has it, is a candidate; it explains a detection of another frame where its
// projection fits the box. The candidate that explains most becomes an object, takes its detections with it,
// and so on. With a wrong scale, what one frame shows is elsewhere in others, or larger or smaller: over
// scales, what is explained has its maximum near the true one, however far off the front end's is.
#pragma once

#include <utility>
#include <vector>

#include "mapping/map_frame.h"
#include "mapping/map_graph.h"

namespace armature {

struct ObjectCandidate {
  GraphObject object;
  std::vector<std::pair<size_t, size_t>> views;  // frame and observation, by time
  double support = 0;  // logarithm of how much likelier the detections are with it than without it
};

struct ObjectSearchOptions {
  size_t most_views = 400;     // that candidates are made of
  size_t most_frames = 250;    // that are asked what a candidate explains in them
  int least_observations = 4;  // that make an object
};

// The best supported first; a detection is of one object at most. T_world_camera: metres, one a frame.
std::vector<ObjectCandidate> SearchObjects(const std::vector<MapFrame>& frames,
                                           const std::vector<Eigen::Isometry3d>& T_world_camera,
                                           const ObjectSearchOptions& options);

// What was not seen for longer than so many seconds is another object afterwards; pieces of too few views are
// left out.
std::vector<ObjectCandidate> BreakAtGaps(const std::vector<MapFrame>& frames,
                                         const std::vector<ObjectCandidate>& candidates, double seconds,
                                         int least_observations);

// Metres a unit of odometry, with which most is explained, of scales at which the camera moves as fast as
// cameras in rooms do; `expected` where nothing is found, the odometry does not move, or its sigma is 0.
ScaleEstimate SearchScale(const std::vector<MapFrame>& frames, const ScaleEstimate& expected,
                          int least_observations);

}  // namespace armature
