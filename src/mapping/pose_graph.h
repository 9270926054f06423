// SPDX-License-Identifier: BSD-3-Clause
// A pose graph: poses, and measured motions between pairs of them.
//
// The poses X_i = T_world_i minimise
//   sum over the edges of r^T Omega r,   r = Log(Z_ij^-1 X_i^-1 X_j) in SE(3),   Z_ij = T_from_to,
// without a factor 1/2. r and Omega have the rotation first (se3.h). The fixed poses stay where they are: the
// sum does not change when all poses move together.
#pragma once

#include <vector>

#include "geometry/se3.h"

namespace armature {

struct PoseGraphEdge {
  size_t from = 0;  // indices of poses
  size_t to = 0;
  Eigen::Isometry3d T_from_to = Eigen::Isometry3d::Identity();
  Matrix6d information = Matrix6d::Identity();  // Omega, positive semi-definite; (rad, m)^-2
};

struct PoseGraph {
  std::vector<Eigen::Isometry3d> poses;  // T_world_i
  std::vector<PoseGraphEdge> edges;
  std::vector<size_t> fixed;  // poses held as they are; empty: the first pose
};

enum class PoseGraphStart {
  kAuto,      // the graph's poses, or the chordal ones where those are poor
  kGiven,     // the graph's poses
  kOdometry,  // the measured motions chained along a tree
  kChordal    // see chordal_initialisation.h
};

// What large errors count: an edge with r^T Omega r = s^2 adds rho(s) to the sum. Below the scale nearly s^2.
enum class PoseGraphLoss {
  kSquare,  // s^2
  kHuber,   // beyond the scale c: 2 c s - c^2
  kCauchy   // c^2 log(1 + s^2 / c^2)
};

struct PoseGraphOptions {
  PoseGraphStart start = PoseGraphStart::kAuto;
  PoseGraphLoss loss = PoseGraphLoss::kSquare;
  double loss_scale = 1;  // c, in standard deviations of an edge's error
  int max_iterations = 100;
  double tolerance = 1e-6;  // stop when an iteration lowers the cost by less than this part of it
};

struct PoseGraphResult {
  std::vector<Eigen::Isometry3d> poses;           // T_world_i
  PoseGraphStart start = PoseGraphStart::kGiven;  // the one that was used, never kAuto
  double initial_cost = 0;                        // at that start, with the loss
  double final_cost = 0;
  int iterations = 0;
  bool converged = false;  // otherwise the iterations ran out, or no step lowers the cost
  double start_milliseconds = 0;
  double solve_milliseconds = 0;
};

// Sum of r^T Omega r.
double PoseGraphCost(const PoseGraph& graph, const std::vector<Eigen::Isometry3d>& poses);

// One thread; the same graph gives the same bits. Throws std::invalid_argument when the graph has no pose, an
// edge or a fixed pose names none, or the edges do not connect all poses.
PoseGraphResult SolvePoseGraph(const PoseGraph& graph, const PoseGraphOptions& options);

}  // namespace armature
