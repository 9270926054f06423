// SPDX-License-Identifier: BSD-3-Clause
// The optimum of the map's factor graph (paper 3.5), with Ceres.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mapping/map_graph.h"

namespace armature {

struct MapSolverOptions {
  int max_iterations = 20;       // steps taken
  double loss_scale = 3;         // of the Cauchy loss on an object factor, per square root of its 6 + B rows
  double shape_weight = 1.5;     // multiplies the coefficients in the category's shape prior
  double upright_sigma_deg = 1;  // degrees: of an object's y axis about up; 0: no such factor
  double floor_sigma = 0.02;  // metres: of the floor or the face below an object that stands on it; 0: none
  double scale_drift_sigma = 0.02;  // of the scale's logarithm from knot to knot
};

struct MapSolution {
  double initial_cost = 0, final_cost = 0;  // half the squared norm
  int iterations = 0;
};

// Improves the graph's unknowns where they stand. One thread: same graph, same bytes.
MapSolution SolveMapGraph(MapGraph& graph, const MapSolverOptions& options);

// What the graph leaves uncertain, the first camera being where it is.
struct GraphUncertainty {
  std::optional<double> scale_sigma;  // of the mean of graph.log_scale; none where the scale is held
  // Covariance of each object's unknowns: a step of T_world_object on its right (rotation, then translation),
  // coefficients, log_size (0 where sizes are held); 7 + B numbers.
  std::vector<Eigen::MatrixXd> objects;
};

// None where the graph does not determine its unknowns.
std::optional<GraphUncertainty> ComputeUncertainty(const MapGraph& graph, const MapSolverOptions& options);

}  // namespace armature
