// SPDX-License-Identifier: BSD-3-Clause
// Making libraries of instances from folders of annotated CAD, and finding their neighbours.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "retrieval/retrieve.h"

namespace armature {

// A library of all annotated CAD models in the folder that are of these categories. Meshes whose frame is not
// known are turned to their annotations. Throws InputError: no annotated model in the folder, or none of
// these categories; a malformed file.
InstanceLibrary BuildFolderLibrary(const std::filesystem::path& cad,
                                   const std::vector<CategoryModel>& models);

// The saved index of a category: beside the library's file.
std::filesystem::path IndexFile(const std::filesystem::path& library, const std::string& category);

// The library with the index of each category, loaded where it was saved for these options, else built.
struct OpenLibrary {
  InstanceLibrary library;
  std::vector<InstanceRetrieval> retrievals;  // one a category of the library, in its order

  const InstanceRetrieval* Of(const std::string& category) const;  // null: it has none of this category
};

// Throws InputError as ReadLibrary; the library has none of the models' categories; a saved index that is not
// of this library. The result keeps references to `models`.
std::unique_ptr<OpenLibrary> OpenLibraryFile(const std::filesystem::path& file,
                                             const std::vector<CategoryModel>& models,
                                             const RetrievalOptions& options);

}  // namespace armature
