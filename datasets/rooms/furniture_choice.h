// SPDX-License-Identifier: BSD-3-Clause
// Which models furnish a room, and how large.
#pragma once

#include <string>
#include <vector>

#include "category/training_spec.h"
#include "datasets/cad/cad_instance.h"
#include "datasets/rooms/recipe.h"

namespace armature {

// What there is to furnish rooms with.
struct Furniture {
  std::vector<CadInstance> collection;  // of all collections
  std::vector<TrainingSpec> specs;      // of chairs, tables, laptops
};

// One of the held-out ones that is not larger (metres, along x and z): of our own families, or more often of
// the other collections that have any. Throws InputError when there is none.
CadInstance DrawInstance(const Furniture& furniture, const std::string& category,
                         const Eigen::Vector2d& at_most, Random& random);

// In a size, and a laptop opened, as drawn from the recipe.
CadInstance InDrawnSize(const Furniture& furniture, CadInstance instance, const FurnitureRecipe& sizes,
                        Random& random);

// The length that the category's scale is known by: a seat's height, a top's, a laptop's width; metres.
double MeasureOf(const Furniture& furniture, const CadInstance& instance);

}  // namespace armature
