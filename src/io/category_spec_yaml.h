// SPDX-License-Identifier: BSD-3-Clause
// The specification part of a category's file, shared by the readers and the writer of category_yaml.h.
#pragma once

#include <string>
#include <vector>

#include "category/category_model.h"
#include "category/training_spec.h"
#include "io/yaml_support.h"

namespace armature {

// The keys of a specification; `model` and `training` stand beside them.
std::vector<std::string> CategorySpecKeys();

// Reads and checks the keys above from the top level of a category's file. Throws InputError.
CategorySpec ReadCategorySpec(const YamlMap& root);

// Reads the section `training`. Throws InputError.
TrainingSpec ReadTraining(const YamlMap& training, const CategorySpec& category);

// The YAML lines of the keys above.
std::string CategorySpecText(const CategorySpec& spec);

}  // namespace armature
