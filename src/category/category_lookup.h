// SPDX-License-Identifier: BSD-3-Clause
// Categories by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "category/category_model.h"

namespace armature {

// Null when there is none of that name.
const CategoryModel* FindModel(const std::vector<CategoryModel>& models, const std::string& category);

// These throw InputError when there is none of that name.
const CategoryModel& LookUpModel(const std::vector<CategoryModel>& models, const std::string& category);
const CategoryModel& LookUpModel(const std::vector<std::shared_ptr<const CategoryModel>>& models,
                                 const std::string& category);
const CategorySpec& FindSpec(const std::vector<CategorySpec>& specs, const std::string& category);

std::vector<CategorySpec> CollectSpecs(const std::vector<CategoryModel>& models);

}  // namespace armature
