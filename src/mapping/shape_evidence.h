// SPDX-License-Identifier: BSD-3-Clause
// What all images together say about an object's shape, apart from what its category lets one expect.
#pragma once

#include <Eigen/Core>

#include "mapping/map_graph.h"
#include "mapping/map_solver.h"

namespace armature {

// A Gaussian over the shape's coefficients (standard deviations) in information form, exp(-x^T information x
// / 2 + vector^T x): a leg that was never seen leaves directions without information, where a covariance
// would not exist.
struct ShapeEvidence {
  Eigen::MatrixXd information;  // B x B, symmetric, positive semidefinite
  Eigen::VectorXd vector;       // B, information * mean
};

// Of the graph's object where the solution left it: the observations' factors, weighed by their robust
// losses, and the object's stand on the floor; marginal over its pose and over the map's scale
// (`scale_sigma`: of its logarithm). The category's prior is taken out again: the gradient of all else equals
// that of the prior at the optimum.
ShapeEvidence ComputeShapeEvidence(const MapGraph& graph, int object, double scale_sigma,
                                   const MapSolverOptions& options);

}  // namespace armature
