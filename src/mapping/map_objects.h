// SPDX-License-Identifier: BSD-3-Clause
// The first map: cameras as the odometry has them, an object for each short track of single-view estimates.
#pragma once

#include "mapping/map_frame.h"
#include "mapping/map_graph.h"
#include "mapping/object_factors.h"

namespace armature {

// Of the odometry, each step.
struct StepNoise {
  double rotation_sigma_deg = 0.2;   // degrees
  double translation_sigma = 0.015;  // share of the step's length
  double translation_floor = 0.001;  // metres, added to it
};

// Cameras, odometry factors, scale (held where its sigma is 0) and up; no objects.
MapGraph MakeOdometryGraph(const std::vector<MapFrame>& frames, const ScaleEstimate& expected_scale,
                           const StepNoise& noise);

// The front end's tracks, broken where they were not seen for longer than `recent_seconds`, numbered from 0
// in the order of their first observation. Pieces of fewer than `min_observations` are left out (-1).
ObjectOfObservation BreakTracks(const std::vector<MapFrame>& frames, double recent_seconds,
                                int min_observations);

// Adds the objects of phi to the graph, each where most of its single views agree, and their observations.
// Views that see the front where most see the back say nothing of the turn.
void AddObjects(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, MapGraph& graph);

// Adds the single views of phi about the objects that the graph has.
void AddViewFactors(const std::vector<MapFrame>& frames, const ObjectOfObservation& phi, MapGraph& graph);

// How far b is turned about its y axis against a, radians.
double YawBetween(const Eigen::Isometry3d& T_world_a, const Eigen::Isometry3d& T_world_b);

}  // namespace armature
