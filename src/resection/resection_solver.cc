// SPDX-License-Identifier: BSD-3-Clause
#include "resection/resection_solver.h"

#include <ceres/tiny_solver.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "resection/normal_equations.h"

namespace armature {
namespace {

constexpr double kFirstDamping = 1e-4;  // one over TinySolver's first trust region radius
constexpr double kLeastDiagonal = 1e-6;
constexpr double kGradientTolerance = 1e-10;

template <int kModes>
SolverResult Solve(const ResectionProblem& problem, const SolverOptions& options, Eigen::VectorXd& solution) {
  using Equations = NormalEquations<kModes>;
  using Vector = typename Equations::Vector;
  Vector x = solution;
  Equations at_x = Linearise<kModes>(problem, x.data());
  double damping = kFirstDamping, growth = 2;
  StopReason stop = StopReason::kMaxIterations;
  int iteration = 1;
  for (; iteration < options.max_iterations; ++iteration) {
    if (at_x.gradient.cwiseAbs().maxCoeff() < kGradientTolerance) {
      stop = StopReason::kGradient;
      break;
    }
    typename Equations::Matrix damped = at_x.information;
    damped.diagonal() += damping * at_x.information.diagonal().cwiseMax(kLeastDiagonal);
    const Vector step = -damped.ldlt().solve(at_x.gradient);
    if (step.norm() < options.parameter_tolerance * (x.norm() + options.parameter_tolerance)) {
      stop = StopReason::kStep;
      break;
    }
    const Vector next = x + step;
    // Most steps are taken, so the derivatives come along at once.
    const Equations at_next = Linearise<kModes>(problem, next.data());
    const double change = 2 * (at_x.cost - at_next.cost);
    const double expected = -step.dot(2 * at_x.gradient + at_x.information * step);
    const double gain = change / expected;
    if (gain > 0) {
      x = next;
      at_x = at_next;
      damping *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
      growth = 2;
    } else {
      damping *= growth;
      growth *= 2;
    }
    if (std::abs(change) < options.function_tolerance) {
      stop = StopReason::kCost;
      break;
    }
  }
  solution = x;
  return {at_x.cost, iteration, stop};
}

StopReason TranslateStatus(ceres::TinySolver<ResectionProblem>::Status status) {
  using Solver = ceres::TinySolver<ResectionProblem>;
  switch (status) {
    case Solver::GRADIENT_TOO_SMALL:
      return StopReason::kGradient;
    case Solver::RELATIVE_STEP_SIZE_TOO_SMALL:
      return StopReason::kStep;
    case Solver::COST_TOO_SMALL:
    case Solver::COST_CHANGE_TOO_SMALL:
      return StopReason::kCost;
    case Solver::HIT_MAX_ITERATIONS:
      return StopReason::kMaxIterations;
  }
  return StopReason::kMaxIterations;
}

}  // namespace

std::string_view StopReasonName(StopReason reason) {
  switch (reason) {
    case StopReason::kGradient:
      return "gradient";
    case StopReason::kStep:
      return "step";
    case StopReason::kCost:
      return "cost";
    case StopReason::kMaxIterations:
      return "max_iterations";
    case StopReason::kNotFinite:
      return "not_finite";
  }
  return "unknown";
}

SolverResult SolveResection(const ResectionProblem& problem, const SolverOptions& options,
                            Eigen::VectorXd& x) {
  return problem.Modes() == 7 ? Solve<7>(problem, options, x) : Solve<Eigen::Dynamic>(problem, options, x);
}

SolverResult SolveResectionWithCeres(const ResectionProblem& problem, const SolverOptions& options,
                                     Eigen::VectorXd& x) {
  ceres::TinySolver<ResectionProblem> solver;
  solver.options.max_num_iterations = options.max_iterations;
  solver.options.function_tolerance = options.function_tolerance;
  solver.options.parameter_tolerance = options.parameter_tolerance;
  const auto summary = solver.Solve(problem, &x);
  return {summary.final_cost, summary.iterations, TranslateStatus(summary.status)};
}

}  // namespace armature
