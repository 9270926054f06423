// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/pose_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "mapping/normal_equations.h"
#include "mapping/pose_graph_start.h"
#include "mapping/spanning_tree.h"

namespace armature {
namespace {

using Clock = std::chrono::steady_clock;

// The trust region starts so wide that steps are those of Gauss-Newton wherever they lower the cost. A narrow
// one damps the long chains of a pose graph, which bend at almost no cost, for many iterations.
constexpr double kFirstRadius = 1e10;
constexpr double kLeastRadius = 1e-20;
constexpr double kLeastRatio = 1e-3;     // of the decrease that the linearised residuals promise
constexpr double kNoStep = 1e-12;        // radians, metres
constexpr double kLeastDiagonal = 1e-6;  // of H, of its mean: damping for what no edge measures

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

// Levenberg-Marquardt (Marquardt's scaling, the radius as in Madsen, Nielsen and Tingleff 2004, 3.2):
//   (H + D) d = -g,  D = diag(H) / radius.
class Optimiser {
 public:
  Optimiser(const PoseGraph& graph, std::vector<Eigen::Isometry3d> poses)
      : builder_(graph), cholesky_(builder_.free().count, builder_.below()), poses_(std::move(poses)) {
    builder_.BuildAt(poses_, equations_);
    if (!std::isfinite(equations_.cost)) throw std::runtime_error("pose graph: the cost is not finite");
  }

  void Run(const PoseGraphOptions& options, PoseGraphResult& result) {
    result.initial_cost = equations_.cost;
    result.converged = builder_.free().count == 0;
    while (!result.converged && result.iterations < options.max_iterations && radius_ > kLeastRadius) {
      ++result.iterations;
      result.converged = Iterate(options.tolerance);
    }
    result.final_cost = equations_.cost;
    result.poses = poses_;
  }

 private:
  // Takes the step if it lowers the cost; true when there is nothing left to gain.
  bool Iterate(double tolerance) {
    const Eigen::VectorXd damping = Damping();
    std::vector<Matrix6d> diagonal = equations_.diagonal;
    for (size_t i = 0; i < diagonal.size(); ++i) {
      diagonal[i].diagonal() += damping.segment<6>(6 * static_cast<long>(i));
    }
    if (!cholesky_.Factorize(diagonal, equations_.below)) return Narrow();
    const Eigen::VectorXd step = -cholesky_.Solve(equations_.gradient);
    // |r|^2 - |r + J d|^2 = -2 g.d - d.H d, and H d = -g - D d.
    const double promised = step.dot(damping.cwiseProduct(step) - equations_.gradient);
    const std::vector<Eigen::Isometry3d> moved = Moved(step);
    const double before = equations_.cost, gained = before - builder_.CostAt(moved);
    const bool is_last = step.lpNorm<Eigen::Infinity>() < kNoStep || promised <= tolerance * before;
    if (!(gained > kLeastRatio * promised)) return is_last || Narrow();
    poses_ = moved;
    builder_.BuildAt(poses_, equations_);
    Widen(gained / promised);
    return is_last || gained <= tolerance * before;
  }

  Eigen::VectorXd Damping() const {
    Eigen::VectorXd diagonal(equations_.gradient.size());
    for (size_t i = 0; i < equations_.diagonal.size(); ++i) {
      diagonal.segment<6>(6 * static_cast<long>(i)) = equations_.diagonal[i].diagonal();
    }
    return diagonal.cwiseMax(kLeastDiagonal * diagonal.mean()) / radius_;
  }

  std::vector<Eigen::Isometry3d> Moved(const Eigen::VectorXd& step) const {
    std::vector<Eigen::Isometry3d> moved = poses_;
    for (size_t pose = 0; pose < moved.size(); ++pose) {
      const int index = builder_.free().index[pose];
      if (index == kFixedPose) continue;
      Eigen::Isometry3d& T = moved[pose];
      T = T * ExpSE3(step.segment<6>(6L * index));
      T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();  // rounding adds up
    }
    return moved;
  }

  bool Narrow() {
    radius_ /= narrowing_;
    narrowing_ *= 2;
    return false;
  }

  void Widen(double ratio) {
    radius_ /= std::max(1 / 3.0, 1 - std::pow(2 * ratio - 1, 3));
    narrowing_ = 2;
  }

  NormalEquationsBuilder builder_;
  BlockCholesky cholesky_;
  std::vector<Eigen::Isometry3d> poses_;
  NormalEquations equations_;  // at poses_
  double radius_ = kFirstRadius;
  double narrowing_ = 2;  // the next divisor of the radius
};

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
  StartingPoses start = FindStartingPoses(graph, options.start);
  result.start = start.start;
  result.start_milliseconds = MillisecondsSince(clock);

  clock = Clock::now();
  Optimiser(graph, std::move(start.poses)).Run(options, result);
  result.solve_milliseconds = MillisecondsSince(clock);
  return result;
}

}  // namespace armature
