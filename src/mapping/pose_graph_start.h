// SPDX-License-Identifier: BSD-3-Clause
// Where the iterations of a pose graph start.
#pragma once

#include "mapping/pose_graph.h"

namespace armature {

struct StartingPoses {
  PoseGraphStart start = PoseGraphStart::kGiven;  // never kAuto
  std::vector<Eigen::Isometry3d> poses;           // T_world_i
};

// kAuto: the graph's own poses, unless noise does not explain their cost and the chordal ones cost less.
StartingPoses FindStartingPoses(const PoseGraph& graph, PoseGraphStart start);

}  // namespace armature
