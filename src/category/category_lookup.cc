// SPDX-License-Identifier: BSD-3-Clause
#include "category/category_lookup.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"

namespace armature {
namespace {

InputError UnknownCategory(const std::string& category) {
  return InputError(
      fmt::format("no category '{}' among the category models; add its file, or name the folder that "
                  "has it with --categories",
                  category));
}

}  // namespace

const CategoryModel* FindModel(const std::vector<CategoryModel>& models, const std::string& category) {
  const auto found = std::find_if(models.begin(), models.end(),
                                  [&](const CategoryModel& model) { return model.spec.name == category; });
  return found == models.end() ? nullptr : &*found;
}

const CategoryModel& LookUpModel(const std::vector<CategoryModel>& models, const std::string& category) {
  const CategoryModel* found = FindModel(models, category);
  if (found == nullptr) throw UnknownCategory(category);
  return *found;
}

const CategoryModel& LookUpModel(const std::vector<std::shared_ptr<const CategoryModel>>& models,
                                 const std::string& category) {
  const auto found = std::find_if(models.begin(), models.end(),
                                  [&](const auto& model) { return model->spec.name == category; });
  if (found == models.end()) throw UnknownCategory(category);
  return **found;
}

const CategorySpec& FindSpec(const std::vector<CategorySpec>& specs, const std::string& category) {
  const auto found = std::find_if(specs.begin(), specs.end(),
                                  [&](const CategorySpec& spec) { return spec.name == category; });
  if (found == specs.end()) throw UnknownCategory(category);
  return *found;
}

std::vector<CategorySpec> CollectSpecs(const std::vector<CategoryModel>& models) {
  std::vector<CategorySpec> specs;
  specs.reserve(models.size());
  for (const CategoryModel& model : models) specs.push_back(model.spec);
  return specs;
}

}  // namespace armature
