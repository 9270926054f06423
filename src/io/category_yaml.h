// SPDX-License-Identifier: BSD-3-Clause
// Categories on disk. A specification (configs/categories/specs) says what a category is and how to learn it;
// a model (configs/categories) is the same specification with what was learnt in its section `model`. Every
// reader throws InputError naming file and line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "category/training_spec.h"

namespace armature {

// The specification of either kind of file.
CategorySpec LoadCategorySpec(const std::filesystem::path& file);

// A specification with its section `training`.
TrainingSpec LoadTrainingSpec(const std::filesystem::path& file);

// A model: checks that the basis is orthonormal and that the base edges' D1 x D2 of the mean shape points up.
CategoryModel LoadCategory(const std::filesystem::path& file);

// All *.yaml of the directory itself, sorted by file name; throws InputError when there is none or two have
// one name.
std::vector<CategoryModel> LoadCategories(const std::filesystem::path& directory);

// The text of a model file. Numbers have nine significant digits: reading it and writing it again gives the
// same text, but the model read differs from the one written in the tenth digit, so use the one that was
// read.
std::string CategoryText(const CategoryModel& model);

// Writes CategoryText aside and renames it; creates the folders around the file. Throws InputError when the
// file cannot be written.
void WriteCategory(const CategoryModel& model, const std::filesystem::path& file);

}  // namespace armature
