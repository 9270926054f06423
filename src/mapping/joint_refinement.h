// SPDX-License-Identifier: BSD-3-Clause
// All frames' lines at once: camera poses, object poses, and one shape and size an object.
//
// Each round matches the segments of every observation anew, to the wireframe where the map has it; replaces
// the observation's factor by these matches' residuals (lines and box), linearised there; and solves the
// graph. With the matches held, that is Gauss and Newton on the joint line problem, but a factor is 6 + B
// rows however many lines there are.
#pragma once

#include <vector>

#include "mapping/map_frame.h"
#include "mapping/map_graph.h"
#include "mapping/object_factors.h"

namespace armature {

// Rounds go from coarse to fine: the gate narrows.
struct RefinementOptions {
  int rounds = 10;                // 0: none
  double first_gate_pixels = 16;  // distance gate of the first round's matches; their sigma goes with it
  double last_gate_pixels = 4;    // and of the last's
};

inline constexpr int kRefinementSteps = 1;        // of the solver in each round: matches change anyway
inline constexpr double kRefinementAngleDeg = 6;  // angle gate, degrees

// Replaces graph.observations: a factor for each observation that phi gives an object and that has matches
// within the gate of this round.
void Relinearise(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, int round,
                 const BoxOptions& box, const ResectionOptions& resection, const RefinementOptions& options,
                 MapGraph& graph);

}  // namespace armature
