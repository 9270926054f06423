// SPDX-License-Identifier: BSD-3-Clause
// Whether two sets of objects of a category vary alike: one set seen in the modes that were learnt from the
// other.
#pragma once

#include <vector>

#include "category/category_model.h"
#include "category/held_out.h"
#include "category/training_spec.h"

namespace armature {

// Of the coefficients, in the model's standard deviations; B values each.
struct CoefficientStatistics {
  Eigen::VectorXd mean, deviation;
};

struct SetStatistics {
  CoefficientStatistics coefficients;
  ReconstructionError error;  // of the model's nearest shapes, with all modes
};

// Coefficients of the training set that the wireframes make (with mirror images where the specification says
// so): mean 0 and deviation 1 for the set that the model is learnt from. Throws InputError for fewer than 2
// wireframes.
SetStatistics ComputeStatistics(const CategoryModel& model, const TrainingSpec& spec,
                                const std::vector<Wireframe>& wireframes);

}  // namespace armature
