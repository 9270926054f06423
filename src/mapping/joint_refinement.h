// SPDX-License-Identifier: BSD-3-Clause
// All frames' lines at once: camera poses, object poses and one shape an object.
//
// Each round matches the segments of every observation anew, to the wireframe where the map has it; replaces
// the observation's factor by these matches' residuals (lines and box), linearised there; and solves the
// graph. With the matches held, that is Gauss and Newton on the joint line problem, but a factor is 6 + B rows
// however many lines there are.
#pragma once

#include <vector>

#include "mapping/map_frame.h"
#include "mapping/map_graph.h"
#include "mapping/object_factors.h"

namespace armature {

struct RefinementOptions {
  int rounds = 8;                // 0: none
  double first_gate_pixels = 8;  // distance gate of the first round's matches
  double last_gate_pixels = 4;   // and of the last's
  double first_box_loss_scale = 30;  // standard deviations: a side far off draws, at first
  double gate_angle_deg = 6;     // degrees
  int min_edges = 2;             // matched edges, fewer say nothing
  FactorNoise noise{.measurement_scale = 3,
                    .depth_sigma = 0.01,
                    .lateral_sigma = 0.01,
                    .rotation_sigma_deg = 1,
                    .shape_sigma = 0.2};
};

// Replaces graph.observations: a factor for each observation that phi gives an object and that has matches
// within the gate.
void Relinearise(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, double gate_pixels,
                 const BoxOptions& box, const ResectionOptions& resection, const RefinementOptions& options,
                 MapGraph& graph);

}  // namespace armature
