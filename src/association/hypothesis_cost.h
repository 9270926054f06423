// SPDX-License-Identifier: BSD-3-Clause
// How badly a hypothesis explains the view: the cost by which the search picks and the winner is chosen.
// Smaller is better; every term is a negative log-likelihood up to a constant.
#pragma once

#include "association/box_constraints.h"
#include "association/hypotheses.h"
#include "association/matching.h"

namespace armature {

struct CostOptions {
  double box_weight = 0.5;         // of the squared, robust box residuals
  double azimuth_sigma_deg = 10;   // degrees: standard deviation of the prior's azimuth
  double azimuth_outliers = 0.05;  // share of priors that are simply wrong
  double azimuth_weight = 1;       // of the prior's negative log-likelihood
};

// Everything but the lines. `wireframe` is the estimate's, `projected` its edges clipped to the hypothesis's
// ClipBox; their visibility is not needed.
double PriorCost(const ObjectView& view, const PoseAndShape& estimate, const Wireframe& wireframe,
                 const BoxSides& sides, const ProjectedWireframe& projected, const BoxOptions& box_options,
                 const CostOptions& options);

// What the lines say, from the explained length in pixels.
double LineCost(const ProjectedWireframe& projected, double covered_length);

}  // namespace armature
