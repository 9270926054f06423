// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/spanning_tree.h"

#include <numeric>

#include "mapping/free_poses.h"

namespace armature {
namespace {

// Sets of poses that are connected so far (union-find with path halving).
class ConnectedSets {
 public:
  explicit ConnectedSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  size_t Root(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Whether they were apart before.
  bool Merge(size_t a, size_t b) {
    a = Root(a);
    b = Root(b);
    parent_[b] = a;
    return a != b;
  }

 private:
  std::vector<size_t> parent_;
};

bool IsConsecutive(const PoseGraphEdge& edge) { return edge.from + 1 == edge.to || edge.to + 1 == edge.from; }

// The edges of the tree at each of their two poses. The fixed poses count as connected already.
std::vector<std::vector<const PoseGraphEdge*>> TreeEdges(const PoseGraph& graph) {
  ConnectedSets sets(graph.poses.size());
  const std::vector<size_t> fixed = FixedPoses(graph);
  for (const size_t pose : fixed) sets.Merge(fixed.front(), pose);
  std::vector<std::vector<const PoseGraphEdge*>> tree(graph.poses.size());
  for (const bool consecutive : {true, false}) {
    for (const PoseGraphEdge& edge : graph.edges) {
      if (IsConsecutive(edge) != consecutive || !sets.Merge(edge.from, edge.to)) continue;
      tree[edge.from].push_back(&edge);
      tree[edge.to].push_back(&edge);
    }
  }
  return tree;
}

}  // namespace

std::optional<size_t> FirstUnconnectedPose(const PoseGraph& graph) {
  ConnectedSets sets(graph.poses.size());
  const std::vector<size_t> fixed = FixedPoses(graph);
  for (const size_t pose : fixed) sets.Merge(fixed.front(), pose);
  for (const PoseGraphEdge& edge : graph.edges) sets.Merge(edge.from, edge.to);
  for (size_t pose = 0; pose < graph.poses.size(); ++pose) {
    if (sets.Root(pose) != sets.Root(fixed.front())) return pose;
  }
  return std::nullopt;
}

std::vector<Eigen::Isometry3d> ChainedPoses(const PoseGraph& graph) {
  const auto tree = TreeEdges(graph);
  std::vector<Eigen::Isometry3d> poses = graph.poses;
  std::vector<size_t> queue = FixedPoses(graph);
  std::vector<bool> is_placed(poses.size(), false);
  for (const size_t pose : queue) is_placed[pose] = true;
  for (size_t i = 0; i < queue.size(); ++i) {
    const size_t pose = queue[i];
    for (const PoseGraphEdge* edge : tree[pose]) {
      const bool forwards = edge->from == pose;
      const size_t next = forwards ? edge->to : edge->from;
      if (is_placed[next]) continue;
      poses[next] = poses[pose] * (forwards ? edge->T_from_to : edge->T_from_to.inverse());
      is_placed[next] = true;
      queue.push_back(next);
    }
  }
  return poses;
}

}  // namespace armature
