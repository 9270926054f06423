// SPDX-License-Identifier: BSD-3-Clause
// Trees in a pose graph: whether its edges connect all poses, and poses chained along measured motions.
#pragma once

#include <optional>

#include "mapping/pose_graph.h"

namespace armature {

// The first pose that no chain of edges connects to a fixed pose.
std::optional<size_t> FirstUnconnectedPose(const PoseGraph& graph);

// Poses from measured motions alone, chained from the fixed poses along a tree. Edges between consecutive
// poses go into the tree first (odometry), then the others in their order. Poses that are not connected stay
// as they are.
std::vector<Eigen::Isometry3d> ChainedPoses(const PoseGraph& graph);

}  // namespace armature
