// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "mapping/block_cholesky.h"
#include "mapping/dense_front.h"

namespace armature {
namespace {

struct BlockMatrix {
  std::vector<BlockCholesky::BlockIndex> below;
  std::vector<Matrix6d> diagonal, below_blocks;

  Eigen::MatrixXd Dense() const {
    const auto count = static_cast<Eigen::Index>(diagonal.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6 * count, 6 * count);
    for (Eigen::Index i = 0; i < count; ++i) A.block<6, 6>(6 * i, 6 * i) = diagonal[static_cast<size_t>(i)];
    for (size_t i = 0; i < below.size(); ++i) {
      const auto [row, column] = below[i];
      A.block<6, 6>(6L * row, 6L * column) = below_blocks[i];
      A.block<6, 6>(6L * column, 6L * row) = below_blocks[i].transpose();
    }
    return A;
  }
};

// Symmetric with a dominant diagonal; each block below it is there with this probability.
BlockMatrix RandomMatrix(int blocks, double density, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::bernoulli_distribution is_there(density);
  const auto block = [&] { return Matrix6d(Matrix6d::NullaryExpr([&] { return uniform(random); })); };
  BlockMatrix matrix;
  for (int i = 0; i < blocks; ++i) {
    const Matrix6d A = block();
    matrix.diagonal.push_back(A * A.transpose() + 6 * blocks * Matrix6d::Identity());
    for (int j = 0; j < i; ++j) {
      if (!is_there(random)) continue;
      matrix.below.emplace_back(i, j);
      matrix.below_blocks.push_back(block());
    }
  }
  return matrix;
}

// Both the kernel and a plain factorisation of the same matrix, whatever the sizes and however they fit the
// processor's vectors.
TEST(DenseFront, EliminatesAsADenseFactorisation) {
  for (const int pivots : {6, 12, 30}) {
    for (const int rest : {0, 6, 12, 18, 66}) {
      const int rows = pivots + rest;
      const Eigen::MatrixXd A = RandomMatrix(rows / 6, 1, 1).Dense();
      Eigen::MatrixXd panel = Eigen::MatrixXd::Zero(rows + kRowPadding, pivots);
      Eigen::MatrixXd update = Eigen::MatrixXd::Zero(rest + kRowPadding, rest);
      panel.topRows(rows) = A.leftCols(pivots);
      update.topRows(rest) = A.bottomRightCorner(rest, rest);
      ASSERT_TRUE(EliminatePivots(rows, pivots, panel.data(), update.data()));
      const Eigen::MatrixXd L = A.llt().matrixL();
      const Eigen::MatrixXd L2 = L.bottomRightCorner(rest, rest);
      const Eigen::MatrixXd found = panel.topRows(rows).triangularView<Eigen::Lower>();
      EXPECT_TRUE(found.isApprox(L.leftCols(pivots), 1e-12)) << rows << " " << pivots;
      const Eigen::MatrixXd left = update.topRows(rest).triangularView<Eigen::Lower>();
      const Eigen::MatrixXd expected = (L2 * L2.transpose()).triangularView<Eigen::Lower>();
      EXPECT_LT((left - expected).norm(), 1e-12 * A.norm()) << rows << " " << pivots;
    }
  }
}

TEST(BlockCholesky, SolvesAsADenseSolver) {
  for (const int blocks : {1, 2, 7, 40}) {
    for (const double density : {0.0, 0.05, 0.3, 1.0}) {
      const BlockMatrix matrix = RandomMatrix(blocks, density, 2);
      const Eigen::MatrixXd A = matrix.Dense();
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
      BlockCholesky cholesky(blocks, matrix.below);
      ASSERT_TRUE(cholesky.Factorize(matrix.diagonal, matrix.below_blocks));
      EXPECT_TRUE(cholesky.Solve(b).isApprox(A.llt().solve(b), 1e-10)) << blocks << " " << density;
    }
  }
}

TEST(BlockCholesky, SolvesAnotherMatrixOfTheSamePattern) {
  const BlockMatrix first = RandomMatrix(20, 0.2, 3);
  BlockMatrix second = first;
  for (Matrix6d& block : second.below_blocks) block *= -0.5;
  BlockCholesky cholesky(20, first.below);
  ASSERT_TRUE(cholesky.Factorize(first.diagonal, first.below_blocks));
  ASSERT_TRUE(cholesky.Factorize(second.diagonal, second.below_blocks));
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(120);
  EXPECT_TRUE((second.Dense() * cholesky.Solve(b)).isApprox(b, 1e-10));
}

TEST(BlockCholesky, SaysWhenTheMatrixIsNotPositiveDefinite) {
  BlockMatrix matrix = RandomMatrix(10, 0.3, 4);
  BlockCholesky cholesky(10, matrix.below);
  matrix.diagonal[7](3, 3) = -1;
  EXPECT_FALSE(cholesky.Factorize(matrix.diagonal, matrix.below_blocks));
  matrix.diagonal[7](3, 3) = std::nan("");
  EXPECT_FALSE(cholesky.Factorize(matrix.diagonal, matrix.below_blocks));
}

TEST(BlockCholesky, TakesAMatrixWithoutUnknowns) {
  BlockCholesky cholesky(0, {});
  EXPECT_TRUE(cholesky.Factorize({}, {}));
  EXPECT_EQ(cholesky.Solve(Eigen::VectorXd()).size(), 0);
}

}  // namespace
}  // namespace armature
