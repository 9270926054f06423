// SPDX-License-Identifier: BSD-3-Clause
// How badly a hypothesis explains the view: the cost by which the search picks and the winner is chosen.
// Smaller is better; every term is a negative log-likelihood up to a constant.
#pragma once

#include "association/box_constraints.h"
#include "association/hypotheses.h"
#include "association/matching.h"

namespace armature {

struct CostOptions {
  double coverage_weight = 12;     // of the share of the visible projected length that no segment explains
  double length_weight = 0;        // of the explained length itself, in units of the box's diagonal
  double box_weight = 0.5;         // of the squared, robust box residuals
  double box_loss_scale = 3;       // standard deviations
  double azimuth_sigma_deg = 10;   // degrees: standard deviation of the prior's azimuth
  double azimuth_outliers = 0.05;  // share of priors that are simply wrong
  double azimuth_weight = 1;       // of the prior's negative log-likelihood
  double shape_weight = 0.15;      // of the squared coefficients
  double floor_weight = 0.5;       // of the squared, robust floor residual
  double memory_weight = 0.3;      // of the squared, robust distance from the remembered pose and shape
  double memory_loss_scale = 4;    // standard deviations
  double yaw_memory_cap = 6;       // the remembered viewpoint priors cost at most this
};

// Everything but the lines. `wireframe` is the estimate's, `projected` its edges clipped to the hypothesis's
// ClipBox; their visibility is not needed.
double PriorCost(const ObjectView& view, const PoseAndShape& estimate, const Wireframe& wireframe,
                 const BoxSides& sides, const ProjectedWireframe& projected, const BoxOptions& box_options,
                 const CostOptions& options);

// What the lines say, from the explained length in pixels.
double LineCost(const ObjectView& view, const ProjectedWireframe& projected, double covered_length,
                const CostOptions& options);

}  // namespace armature
