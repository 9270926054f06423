// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/free_poses.h"

namespace armature {

std::vector<size_t> FixedPoses(const PoseGraph& graph) {
  return graph.fixed.empty() ? std::vector<size_t>{0} : graph.fixed;
}

FreePoses FindFreePoses(const PoseGraph& graph) {
  FreePoses free;
  free.index.assign(graph.poses.size(), 0);
  for (const size_t pose : FixedPoses(graph)) free.index[pose] = kFixedPose;
  for (int& index : free.index) {
    if (index != kFixedPose) index = free.count++;
  }
  return free;
}

}  // namespace armature
