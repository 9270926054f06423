// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_graph.h"

#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "mapping/chordal_initialisation.h"
#include "mapping/pose_block.h"
#include "mapping/relative_pose_cost.h"
#include "mapping/spanning_tree.h"

namespace armature {
namespace {

using Clock = std::chrono::steady_clock;

// A start is poor when its whitened residuals have a root mean square above 3. Where the information is
// honest it is about 1 at the optimum, so on average the start contradicts each measurement by more than
// three standard deviations: it lies outside of what the measurements leave open.
constexpr double kPoorResidual = 3;

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

struct Start {
  PoseGraphStart kind = PoseGraphStart::kGiven;
  std::vector<Eigen::Isometry3d> poses;
};

// A lower cost does not prove a better basin, but a chordal start has no wrong turns of its own to hide: what
// it leaves is the noise of the measurements.
Start AutomaticStart(const PoseGraph& graph) {
  const double given_cost = PoseGraphCost(graph, graph.poses);
  const double residuals = 6.0 * static_cast<double>(graph.edges.size());
  if (!(given_cost > kPoorResidual * kPoorResidual * residuals)) return {PoseGraphStart::kGiven, graph.poses};
  Start chordal{PoseGraphStart::kChordal, ChordalPoses(graph)};
  if (PoseGraphCost(graph, chordal.poses) < given_cost) return chordal;
  return {PoseGraphStart::kGiven, graph.poses};
}

Start StartPoses(const PoseGraph& graph, PoseGraphStart kind) {
  switch (kind) {
    case PoseGraphStart::kAuto:
      return AutomaticStart(graph);
    case PoseGraphStart::kOdometry:
      return {kind, ChainedPoses(graph)};
    case PoseGraphStart::kChordal:
      return {kind, ChordalPoses(graph)};
    case PoseGraphStart::kGiven:
      break;
  }
  return {PoseGraphStart::kGiven, graph.poses};
}

void BuildProblem(const PoseGraph& graph, PoseManifold& manifold, std::vector<PoseBlock>& blocks,
                  ceres::Problem& problem) {
  for (PoseBlock& block : blocks) problem.AddParameterBlock(block.data(), 7, &manifold);
  for (const size_t pose : FixedPoses(graph)) problem.SetParameterBlockConstant(blocks[pose].data());
  for (const PoseGraphEdge& edge : graph.edges) {
    problem.AddResidualBlock(new RelativePoseCost(edge), nullptr, blocks[edge.from].data(),
                             blocks[edge.to].data());
  }
}

ceres::Solver::Options SolverOptions(const PoseGraphOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.initial_trust_region_radius = kTrustRegionRadius;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.tolerance;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  return solver;
}

// Improves result.poses.
void Optimise(const PoseGraph& graph, const PoseGraphOptions& options, PoseGraphResult& result) {
  PoseManifold manifold;
  std::vector<PoseBlock> blocks(graph.poses.size());
  std::transform(result.poses.begin(), result.poses.end(), blocks.begin(), ToPoseBlock);
  ceres::Problem::Options problem_options;
  problem_options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  BuildProblem(graph, manifold, blocks, problem);

  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(options), &problem, &summary);
  if (!summary.IsSolutionUsable()) {
    throw std::runtime_error(fmt::format("pose graph: the solver failed: {}", summary.message));
  }
  for (size_t pose = 0; pose < blocks.size(); ++pose) {
    if (!problem.IsParameterBlockConstant(blocks[pose].data())) {
      result.poses[pose] = FromPoseBlock(blocks[pose].data());
    }
  }
  result.initial_cost = 2 * summary.initial_cost;  // Ceres counts half of it
  result.final_cost = 2 * summary.final_cost;
  result.iterations = std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  result.converged = summary.termination_type == ceres::CONVERGENCE;
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
  PoseGraphResult result;
  Clock::time_point clock = Clock::now();
  Start start = StartPoses(graph, options.start);
  result.start = start.kind;
  result.poses = std::move(start.poses);
  result.start_milliseconds = MillisecondsSince(clock);

  clock = Clock::now();
  Optimise(graph, options, result);
  result.solve_milliseconds = MillisecondsSince(clock);
  return result;
}

}  // namespace armature
