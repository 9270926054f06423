// SPDX-License-Identifier: BSD-3-Clause
// How long the unit of a monocular odometry is.
#pragma once

namespace armature {

// The odometry's scale as far as it is known. What is Gaussian is its logarithm.
struct ScaleEstimate {
  double scale = 1;  // metres a unit of odometry
  double sigma = 3;  // standard deviation of its logarithm

  bool IsKnown() const { return sigma < 0.1; }
};

}  // namespace armature
