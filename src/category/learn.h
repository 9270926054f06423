// SPDX-License-Identifier: BSD-3-Clause
// Learning a category model (paper 3.2): the mean shape and the main directions of deformation of annotated
// models by principal component analysis, and a dictionary of representative models.
#pragma once

#include <vector>

#include "category/category_model.h"
#include "category/training_spec.h"

namespace armature {

// The wireframes (metres, object frame, centred) and, where the specification says so, their mirror images
// after them.
std::vector<Wireframe> TrainingSet(const TrainingSpec& spec, const std::vector<Wireframe>& wireframes);

// X = mean + V Lambda (paper eq. 5) with the spec.modes directions of largest variance, from the SVD
// of the centred shape vectors; fewer modes where the models span less. Signs: each mode's largest component
// is positive. The dictionary are k-medoids of the given wireframes (not of their mirror images), compared by
// their shapes within the basis, that is by coefficients times standard deviations, in metres: a centimetre
// counts the same in every mode. `source` and `training_models` (without mirror images) are set; throws
// InputError for fewer than 2 wireframes, another number of edges than the specification's, or wireframes
// that are all the same.
CategoryModel LearnCategory(const TrainingSpec& spec, const std::vector<Wireframe>& wireframes,
                            const std::string& source);

// Share of the training set's variance that each mode holds, B values in [0, 1].
Eigen::VectorXd ExplainedVariance(const CategoryModel& model);

}  // namespace armature
