// SPDX-License-Identifier: BSD-3-Clause
// Categories by name, where an evaluation meets one in its input.
#pragma once

#include <string>
#include <vector>

#include "category/category_model.h"

namespace armature {

// Both throw InputError when there is none of that name.
const CategoryModel& LookUpModel(const std::vector<CategoryModel>& models, const std::string& category);
const CategorySpec& FindSpec(const std::vector<CategorySpec>& specs, const std::string& category);

std::vector<CategorySpec> CollectSpecs(const std::vector<CategoryModel>& models);

}  // namespace armature
