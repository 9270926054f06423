// SPDX-License-Identifier: BSD-3-Clause
// The minimum of a ResectionProblem by Levenberg and Marquardt.
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "resection/resection_problem.h"

namespace armature {

struct SolverOptions {
  int max_iterations = 5;
  double function_tolerance = 1e-3;   // of the squared norm of the residuals, absolute
  double parameter_tolerance = 1e-4;  // of a step against the unknowns
};

// Why a solver stopped.
enum class StopReason {
  kGradient,       // the gradient vanishes: a minimum
  kStep,           // the next step would be too small to matter: a minimum
  kCost,           // the last step hardly changed the cost: a minimum, to the tolerance
  kMaxIterations,  // it was still on the way
  kNotFinite,      // it left the numbers: the result is of no use
};
std::string_view StopReasonName(
    StopReason reason);  // "gradient", "step", "cost", "max_iterations", "not_finite"

struct SolverResult {
  double cost = 0;  // half the squared norm of the residuals
  int iterations = 0;
  StopReason stop = StopReason::kMaxIterations;
};

// Our own: normal equations of a size known to the compiler (B = 7; any other number is as right and a little
// slower). Steps, damping and stopping rules are those of ceres::TinySolver, so that both take the same way.
// x: 6+B unknowns, from the start to the minimum.
SolverResult SolveResection(const ResectionProblem& problem, const SolverOptions& options,
                            Eigen::VectorXd& x);

// The reference: ceres::TinySolver. Respects pose_is_free and shape_is_free, which ours does not know.
SolverResult SolveResectionWithCeres(const ResectionProblem& problem, const SolverOptions& options,
                                     Eigen::VectorXd& x);

}  // namespace armature
