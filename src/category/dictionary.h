// SPDX-License-Identifier: BSD-3-Clause
// Choosing representative models for the association's dictionary ("3-5 most representative CAD models",
// which the paper selects manually, 3.3): k-medoids, so that each one is a model that exists.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace armature {

struct MedoidsResult {
  std::vector<int> medoids;     // indices of points, the one with most members first
  std::vector<int> assignment;  // for each point the position of its medoid in `medoids`
  double cost = 0;              // sum of distances of the points from their medoids, in the points' unit
};

// k-medoids of the points (columns, Euclidean distance) by BUILD and SWAP of PAM (Kaufman and Rousseeuw
// 1990). Deterministic: ties go to the lower index. Fewer than k points give as many medoids as there are
// points.
MedoidsResult KMedoids(const Eigen::MatrixXd& points, int k);

}  // namespace armature
