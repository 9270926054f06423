// SPDX-License-Identifier: BSD-3-Clause
// Category models of single objects.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "category/category_model.h"
#include "eval/budget/substituted_truth.h"
#include "truth/ground_truth.h"

namespace armature {

// Folder of the models in a substituted sequence folder.
inline constexpr const char* kModelsFolder = "categories";

// The category's mean as large as the object (`size`: metres, along its axes, padding included), and its
// variations and sigma of size at a hundredth: how large it is and how it is built is known.
CategoryModel ModelOfSize(CategoryModel model, const Eigen::Vector3d& size);

// categories/<id>.yaml of each true object: its category's model under its id; `sized`: by ModelOfSize.
// Throws InputError for a category without model.
SubstitutedFiles ModelsOfObjects(const std::vector<TrueObject>& objects,
                                 const std::vector<CategoryModel>& models, bool sized);

}  // namespace armature
