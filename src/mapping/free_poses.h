// SPDX-License-Identifier: BSD-3-Clause
// Which poses of a graph are held and which are unknowns.
#pragma once

#include "mapping/pose_graph.h"

namespace armature {

constexpr int kFixedPose = -1;

struct FreePoses {
  std::vector<int> index;  // of each pose among those that are free, or kFixedPose
  int count = 0;
};

// The graph's fixed poses, or the first pose where it names none.
std::vector<size_t> FixedPoses(const PoseGraph& graph);

FreePoses FindFreePoses(const PoseGraph& graph);

}  // namespace armature
