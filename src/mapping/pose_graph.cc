// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_graph.h"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "mapping/far_start.h"
#include "mapping/free_poses.h"
#include "mapping/interruptible_solve.h"
#include "mapping/one_thread.h"
#include "mapping/pose_block.h"
#include "mapping/pose_graph_start.h"
#include "mapping/relative_pose_cost.h"
#include "mapping/spanning_tree.h"

namespace armature {
namespace {

using Clock = std::chrono::steady_clock;

// Gauss-Newton steps wherever they lower the cost: the damping that this radius leaves is below rounding.
// Ceres' default of 1e4 damps pose graphs, whose long chains bend at almost no cost, for several iterations.
constexpr double kTrustRegionRadius = 1e10;

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void CheckGraph(const PoseGraph& graph) {
  const size_t poses = graph.poses.size();
  if (poses == 0) throw std::invalid_argument("pose graph: has no pose");
  const auto is_missing = [poses](size_t pose) { return pose >= poses; };
  for (const PoseGraphEdge& edge : graph.edges) {
    if (is_missing(edge.from) || is_missing(edge.to) || edge.from == edge.to) {
      throw std::invalid_argument(
          fmt::format("pose graph: an edge from {} to {} among {} poses", edge.from, edge.to, poses));
    }
  }
  if (std::any_of(graph.fixed.begin(), graph.fixed.end(), is_missing)) {
    throw std::invalid_argument("pose graph: a fixed pose does not exist");
  }
  if (const auto pose = FirstUnconnectedPose(graph)) {
    throw std::invalid_argument(fmt::format("pose graph: pose {} is not connected to a fixed one", *pose));
  }
}

ceres::Solver::Options MakeSolverOptions(const PoseGraphOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.use_postordering = true;  // columns of like structure next to each other: larger supernodes
  solver.initial_trust_region_radius = kTrustRegionRadius;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.tolerance;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  return solver;
}

// Nothing is owned by Ceres: one allocation holds all costs, in the order in which they are evaluated.
ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

// None: the square.
std::unique_ptr<ceres::LossFunction> MakeLoss(const PoseGraphOptions& options) {
  switch (options.loss) {
    case PoseGraphLoss::kSquare:
      return nullptr;
    case PoseGraphLoss::kHuber:
      return std::make_unique<ceres::HuberLoss>(options.loss_scale);
    case PoseGraphLoss::kCauchy:
      return std::make_unique<ceres::CauchyLoss>(options.loss_scale);
  }
  std::abort();
}

// Improves result.poses.
void Optimise(const PoseGraph& graph, const PoseGraphOptions& options, PoseGraphResult& result) {
  std::vector<PoseBlock> blocks(graph.poses.size());
  std::transform(result.poses.begin(), result.poses.end(), blocks.begin(), ToBlock);
  std::vector<RelativePoseCost> costs(graph.edges.begin(), graph.edges.end());

  const std::unique_ptr<ceres::LossFunction> loss = MakeLoss(options);
  PoseManifold manifold;
  ceres::Problem problem(ProblemOptions());
  for (PoseBlock& block : blocks) problem.AddParameterBlock(block.data(), 7, &manifold);
  for (const size_t pose : FixedPoses(graph)) problem.SetParameterBlockConstant(blocks[pose].data());
  for (size_t i = 0; i < costs.size(); ++i) {
    problem.AddResidualBlock(&costs[i], loss.get(), blocks[graph.edges[i].from].data(),
                             blocks[graph.edges[i].to].data());
  }
  ceres::Solver::Summary summary;
  const OneThread one_thread;
  SolveUnlessInterrupted(MakeSolverOptions(options), &problem, &summary);
  if (!summary.IsSolutionUsable()) throw std::runtime_error("pose graph: " + summary.message);
  for (size_t pose = 0; pose < blocks.size(); ++pose) {
    // A fixed pose keeps its very bits.
    if (problem.IsParameterBlockConstant(blocks[pose].data())) continue;
    result.poses[pose] = FromBlock(blocks[pose].data());
  }
  result.initial_cost = 2 * summary.initial_cost;  // Ceres counts half of it
  result.final_cost = 2 * summary.final_cost;
  result.iterations = std::max(0, static_cast<int>(summary.iterations.size()) - 1);  // the first is the start
  result.converged = summary.termination_type == ceres::CONVERGENCE;
}

// The same graph where `start` is the origin; a fixed pose keeps its very bits.
PoseGraphResult SolveAbout(const Eigen::Vector3d& start, const PoseGraph& graph,
                           const PoseGraphOptions& options) {
  PoseGraph near = graph;
  for (Eigen::Isometry3d& pose : near.poses) pose.pretranslate(-start);
  PoseGraphResult result = SolvePoseGraph(near, options);
  for (Eigen::Isometry3d& pose : result.poses) pose.pretranslate(start);
  for (const size_t pose : FixedPoses(graph)) result.poses[pose] = graph.poses[pose];
  return result;
}

}  // namespace

double PoseGraphCost(const PoseGraph& graph, const std::vector<Eigen::Isometry3d>& poses) {
  double cost = 0;
  for (const PoseGraphEdge& edge : graph.edges) {
    const Vector6d r = LogSE3(edge.T_from_to.inverse() * poses[edge.from].inverse() * poses[edge.to]);
    cost += r.dot(edge.information * r);
  }
  return cost;
}

PoseGraphResult SolvePoseGraph(const PoseGraph& graph, const PoseGraphOptions& options) {
  CheckGraph(graph);
  if (const auto start = FindFarStart(graph.poses)) return SolveAbout(*start, graph, options);
  PoseGraphResult result;
  Clock::time_point clock = Clock::now();
  StartingPoses start = FindStartingPoses(graph, options.start);
  result.start = start.start;
  result.poses = std::move(start.poses);
  result.start_milliseconds = MillisecondsSince(clock);

  clock = Clock::now();
  Optimise(graph, options, result);
  result.solve_milliseconds = MillisecondsSince(clock);
  return result;
}

}  // namespace armature
