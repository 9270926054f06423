// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/chordal_initialisation.h"

#include <Eigen/SVD>
#include <Eigen/Sparse>
#include <algorithm>
#include <stdexcept>

#include "base/interrupt.h"
#include "mapping/free_poses.h"

namespace armature {
namespace {

// Of the largest weight. Edges that say nothing about rotation (or position) still connect the poses, so the
// systems have one solution; what the others say is not changed in its first six digits.
constexpr double kLeastWeight = 1e-6;

using SparseMatrix = Eigen::SparseMatrix<double>;

// Mean information of each edge on rotation (first = 0) or translation (first = 3).
std::vector<double> Weights(const PoseGraph& graph, int first) {
  std::vector<double> weights;
  for (const PoseGraphEdge& edge : graph.edges) {
    weights.push_back(edge.information.diagonal().segment<3>(first).mean());
  }
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights) weight = largest > 0 ? std::max(weight, kLeastWeight * largest) : 1;
  return weights;
}

// Normal equations A x = b, only the lower triangle of A.
class LinearSystem {
 public:
  explicit LinearSystem(int unknowns) : unknowns_(unknowns), b_(Eigen::MatrixXd::Zero(unknowns, 3)) {}

  template <typename Block>
  void AddBlock(int row, int column, const Block& block) {
    for (int i = 0; i < block.rows(); ++i) {
      for (int j = 0; j < block.cols(); ++j) {
        if (row + i >= column + j && block(i, j) != 0)
          entries_.emplace_back(row + i, column + j, block(i, j));
      }
    }
  }

  template <typename Block>
  void AddRightSide(int row, const Block& block) {
    b_.middleRows(row, block.rows()) += block;
  }

  Eigen::MatrixXd Solve() const {
    SparseMatrix A(unknowns_, unknowns_);
    A.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> ldlt(A);
    if (ldlt.info() != Eigen::Success) throw std::runtime_error("pose graph: chordal system is singular");
    return ldlt.solve(b_);
  }

 private:
  int unknowns_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::MatrixXd b_;
};

Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& M) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

// With x_i = R_i^T, a column an unknown row of R_i, an edge's residual is x_j - R_ij^T x_i.
void SolveRotations(const PoseGraph& graph, const FreePoses& free, std::vector<Eigen::Isometry3d>& poses) {
  LinearSystem system(3 * free.count);
  const std::vector<double> weights = Weights(graph, 0);
  for (size_t e = 0; e < graph.edges.size(); ++e) {
    const PoseGraphEdge& edge = graph.edges[e];
    const int i = free.index[edge.from], j = free.index[edge.to];
    const Eigen::Matrix3d unit = weights[e] * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d turn = weights[e] * edge.T_from_to.linear();
    if (i != kFixedPose) system.AddBlock(3 * i, 3 * i, unit);
    if (j != kFixedPose) system.AddBlock(3 * j, 3 * j, unit);
    if (i != kFixedPose && j != kFixedPose) {
      if (i > j) system.AddBlock(3 * i, 3 * j, (-turn).eval());
      if (j > i) system.AddBlock(3 * j, 3 * i, (-turn.transpose()).eval());
    } else if (i != kFixedPose) {
      system.AddRightSide(3 * i, turn * poses[edge.to].linear().transpose());
    } else if (j != kFixedPose) {
      system.AddRightSide(3 * j, turn.transpose() * poses[edge.from].linear().transpose());
    }
  }
  const Eigen::MatrixXd x = system.Solve();
  for (size_t pose = 0; pose < poses.size(); ++pose) {
    if (free.index[pose] == kFixedPose) continue;
    poses[pose].linear() = NearestRotation(x.middleRows<3>(3L * free.index[pose]).transpose());
  }
}

// Row i of the unknowns is t_i^T.
void SolvePositions(const PoseGraph& graph, const FreePoses& free, std::vector<Eigen::Isometry3d>& poses) {
  LinearSystem system(free.count);
  const std::vector<double> weights = Weights(graph, 3);
  for (size_t e = 0; e < graph.edges.size(); ++e) {
    const PoseGraphEdge& edge = graph.edges[e];
    const int i = free.index[edge.from], j = free.index[edge.to];
    const Eigen::Matrix<double, 1, 1> unit(weights[e]);
    const Eigen::RowVector3d step =
        weights[e] * (poses[edge.from].linear() * edge.T_from_to.translation()).transpose();
    if (i != kFixedPose) system.AddBlock(i, i, unit);
    if (j != kFixedPose) system.AddBlock(j, j, unit);
    if (i != kFixedPose && j != kFixedPose) system.AddBlock(std::max(i, j), std::min(i, j), (-unit).eval());
    if (i != kFixedPose) system.AddRightSide(i, -step);
    if (j != kFixedPose) system.AddRightSide(j, step);
    if (i != kFixedPose && j == kFixedPose) {
      system.AddRightSide(i, weights[e] * poses[edge.to].translation().transpose());
    }
    if (j != kFixedPose && i == kFixedPose) {
      system.AddRightSide(j, weights[e] * poses[edge.from].translation().transpose());
    }
  }
  const Eigen::MatrixXd x = system.Solve();
  for (size_t pose = 0; pose < poses.size(); ++pose) {
    if (free.index[pose] != kFixedPose) poses[pose].translation() = x.row(free.index[pose]).transpose();
  }
}

}  // namespace

std::vector<Eigen::Isometry3d> ChordalPoses(const PoseGraph& graph) {
  const FreePoses free = FindFreePoses(graph);
  std::vector<Eigen::Isometry3d> poses = graph.poses;
  if (free.count == 0 || graph.edges.empty()) return poses;
  ThrowIfInterrupted();
  SolveRotations(graph, free, poses);
  ThrowIfInterrupted();
  SolvePositions(graph, free, poses);
  return poses;
}

}  // namespace armature
