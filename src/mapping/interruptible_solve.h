// SPDX-License-Identifier: BSD-3-Clause
// Ceres' solver as a user can stop it.
#pragma once

#include <ceres/ceres.h>

#include "base/interrupt.h"

namespace armature {

// ceres::Solve, which ends after the iteration in which a signal is noted: throws Interrupted then.
inline void SolveUnlessInterrupted(ceres::Solver::Options options, ceres::Problem* problem,
                                   ceres::Solver::Summary* summary) {
  struct Stop final : ceres::IterationCallback {
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
      return InterruptSignal() == 0 ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
    }
  } stop;
  options.callbacks.push_back(&stop);
  ThrowIfInterrupted();
  ceres::Solve(options, problem, summary);
  ThrowIfInterrupted();
}

}  // namespace armature
