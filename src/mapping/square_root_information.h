// SPDX-License-Identifier: BSD-3-Clause
// Whitening of residuals.
#pragma once

#include <optional>

#include "geometry/se3.h"

namespace armature {

// S with S^T S = Omega, so that |S r|^2 = r^T Omega r. With Omega = L L^T it is S = L^T and not L: the two
// agree for diagonal matrices only. Nothing when Omega is not symmetric or not positive semi-definite.
std::optional<Matrix6d> SquareRootInformation(const Matrix6d& information);

}  // namespace armature
