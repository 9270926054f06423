// SPDX-License-Identifier: BSD-3-Clause
// Libraries of any size for measuring: coefficients that are distributed as those of collected CAD models
// are.
#pragma once

#include <Eigen/Core>

namespace armature {

struct SyntheticLibrary {
  // Columns: instances, seven coefficients each, in standard deviations. A member of one of 300 families
  // (which are normally distributed, deviation 0.9; the first ones have the most members) and its own spread
  // (0.44).
  Eigen::MatrixXf features;
  // Columns: one of the instances each, as it would be estimated, with noise of 0.3 on each coefficient.
  Eigen::MatrixXf queries;
};

// From a fixed seed; instances: at least one.
SyntheticLibrary MakeSyntheticLibrary(Eigen::Index instances, Eigen::Index queries);

}  // namespace armature
