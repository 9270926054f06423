// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of a pose graph: H d = -g for the steps d of the poses that are free, with H = J^T J,
// g = J^T r of the whitened residuals (edge_residual.h).
#pragma once

#include "mapping/block_cholesky.h"
#include "mapping/edge_residual.h"
#include "mapping/free_poses.h"

namespace armature {

struct NormalEquations {
  std::vector<Matrix6d> diagonal, below;  // blocks of H, as BlockCholesky takes them
  Eigen::VectorXd gradient;               // g
  double cost = 0;                        // r^T r
};

// What the graph says about the equations whatever its poses are.
class NormalEquationsBuilder {
 public:
  explicit NormalEquationsBuilder(const PoseGraph& graph);

  double CostAt(const std::vector<Eigen::Isometry3d>& poses) const;
  void BuildAt(const std::vector<Eigen::Isometry3d>& poses, NormalEquations& equations) const;

  const FreePoses& free() const { return free_; }
  // Where H has blocks below its diagonal.
  const std::vector<BlockCholesky::BlockIndex>& below() const { return below_; }

 private:
  struct Edge {
    size_t from, to;  // poses
    int block;        // in below(); kFixedPose: an end is fixed
    EdgeResidual residual;
  };

  void AddEdge(const LinearResidual& linear, const Edge& edge, NormalEquations& equations) const;

  FreePoses free_;
  std::vector<Edge> edges_;
  std::vector<BlockCholesky::BlockIndex> below_;
};

}  // namespace armature
