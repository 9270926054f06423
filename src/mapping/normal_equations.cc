// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/normal_equations.h"

#include <map>

namespace armature {

NormalEquationsBuilder::NormalEquationsBuilder(const PoseGraph& graph) : free_(FindFreePoses(graph)) {
  std::map<BlockCholesky::BlockIndex, int> known;  // edges between the same poses share a block
  edges_.reserve(graph.edges.size());
  for (const PoseGraphEdge& edge : graph.edges) {
    const int from = free_.index[edge.from], to = free_.index[edge.to];
    int block = kFixedPose;
    if (from != kFixedPose && to != kFixedPose) {
      const BlockCholesky::BlockIndex index(std::max(from, to), std::min(from, to));
      const auto [entry, is_new] = known.try_emplace(index, static_cast<int>(below_.size()));
      if (is_new) below_.push_back(index);
      block = entry->second;
    }
    edges_.push_back({edge.from, edge.to, block, EdgeResidual(edge)});
  }
}

double NormalEquationsBuilder::CostAt(const std::vector<Eigen::Isometry3d>& poses) const {
  double cost = 0;
  for (const Edge& edge : edges_) cost += edge.residual.At(poses[edge.from], poses[edge.to]).squaredNorm();
  return cost;
}

void NormalEquationsBuilder::BuildAt(const std::vector<Eigen::Isometry3d>& poses,
                                     NormalEquations& equations) const {
  equations.diagonal.assign(static_cast<size_t>(free_.count), Matrix6d::Zero());
  equations.below.assign(below_.size(), Matrix6d::Zero());
  equations.gradient.setZero(6L * free_.count);
  equations.cost = 0;
  for (const Edge& edge : edges_) {
    const LinearResidual linear = edge.residual.LinearisedAt(poses[edge.from], poses[edge.to]);
    equations.cost += linear.residual.squaredNorm();
    AddEdge(linear, edge, equations);
  }
}

void NormalEquationsBuilder::AddEdge(const LinearResidual& linear, const Edge& edge,
                                     NormalEquations& equations) const {
  const int from = free_.index[edge.from], to = free_.index[edge.to];
  if (from != kFixedPose) {
    equations.diagonal[static_cast<size_t>(from)].noalias() += linear.by_from.transpose() * linear.by_from;
    equations.gradient.segment<6>(6L * from).noalias() += linear.by_from.transpose() * linear.residual;
  }
  if (to != kFixedPose) {
    equations.diagonal[static_cast<size_t>(to)].noalias() += linear.by_to.transpose() * linear.by_to;
    equations.gradient.segment<6>(6L * to).noalias() += linear.by_to.transpose() * linear.residual;
  }
  if (edge.block == kFixedPose) return;
  Matrix6d& block = equations.below[static_cast<size_t>(edge.block)];
  if (to > from) {
    block.noalias() += linear.by_to.transpose() * linear.by_from;
  } else {
    block.noalias() += linear.by_from.transpose() * linear.by_to;
  }
}

}  // namespace armature
