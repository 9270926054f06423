// SPDX-License-Identifier: BSD-3-Clause
// Sparse Cholesky factorisation of a symmetric positive definite matrix of 6x6 blocks: the normal equations
// of a graph of poses. Multifrontal (Duff and Reid 1983): the unknowns are eliminated in an order with little
// fill, neighbouring ones with the same rows together as one dense matrix (dense_front.h). On such graphs it
// takes a third to a sixth of the time of CHOLMOD, whose dense arithmetic is made for larger matrices.
#pragma once

#include <utility>
#include <vector>

#include "geometry/se3.h"

namespace armature {

class BlockCholesky {
 public:
  using BlockIndex = std::pair<int, int>;  // row, column

  // Orders the unknowns and plans the elimination. `below` are the blocks below the diagonal (row > column),
  // each at most once; those on the diagonal are all there.
  BlockCholesky(int blocks, const std::vector<BlockIndex>& below);

  // The matrix' blocks on the diagonal and those below, in the order of the constructor. Of the first only
  // the lower triangle counts. False when the matrix is not positive definite.
  bool Factorize(const std::vector<Matrix6d>& diagonal, const std::vector<Matrix6d>& below);

  // The solution of A x = b after Factorize succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& b) const;

 private:
  static constexpr int kNoParent = -1;

  // Blocks that are eliminated together: columns [first, first + columns) of the new order.
  struct Front {
    int first = 0;
    int columns = 0;
    std::vector<int> rows;          // blocks below them that are not 0, new order, ascending
    long zeros = 0;                 // blocks of the columns that are 0 all the same
    int parent = kNoParent;         // the front of rows[0]
    std::vector<size_t> in_parent;  // where `rows` are among the parent's columns and rows
    size_t panel = 0;               // where the columns start in panels_
  };
  // Where a block of the matrix goes.
  struct Target {
    size_t offset = 0;  // of its first entry in panels_
    size_t stride = 0;
    bool transposed = false;  // the new order swaps row and column
  };
  using Panel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

  void Order(int blocks, const std::vector<BlockIndex>& below);
  void BuildFronts(const std::vector<std::vector<int>>& structure);
  static bool Absorb(const Front& child, Front& front);
  void PlaceFronts();
  size_t LargestStack() const;
  void PlaceBlocks(int blocks, const std::vector<BlockIndex>& below);
  static size_t PositionIn(const Front& front, int block);
  static size_t PanelStride(const Front& front);
  static size_t UpdateSize(const Front& front);
  static Eigen::Index FirstUnknown(const Front& front);
  Panel PanelOf(const Front& front) const;

  void StoreMatrix(const std::vector<Matrix6d>& diagonal, const std::vector<Matrix6d>& below);
  bool FactorizeFronts();
  void AddUpdate(const Front& child, const double* update, const Front& parent, double* parent_update);
  void SolveForwards(Eigen::VectorXd& x) const;
  void SolveBackwards(Eigen::VectorXd& x) const;

  std::vector<int> new_index_;  // of each block
  std::vector<int> front_of_;   // of each block, new order
  std::vector<Front> fronts_;   // children right before their parents
  std::vector<Target> diagonal_targets_, below_targets_;
  std::vector<double> panels_;   // the matrix, then its factor
  std::vector<double> updates_;  // stack of what fronts hand on to their parents
};

}  // namespace armature
