// SPDX-License-Identifier: BSD-3-Clause
#include "cli/instance_libraries.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "cli/align_meshes.h"
#include "cli/configuration.h"
#include "io/cad_folder.h"
#include "io/index_file.h"
#include "io/library_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

InstanceIndex FindIndex(const fs::path& library, const CategoryModel& model,
                        const CategoryInstances& instances, const RetrievalOptions& options) {
  const fs::path file = IndexFile(library, instances.category);
  if (!fs::exists(file)) return BuildIndex(model, instances, options);
  return ReadIndex(file, Features(instances, model.standard_deviations, options.features), options.index);
}

}  // namespace

InstanceLibrary BuildFolderLibrary(const fs::path& cad, const std::vector<CategoryModel>& models) {
  std::vector<CategorySpec> specs;
  specs.reserve(models.size());
  for (const CategoryModel& model : models) specs.push_back(model.spec);
  std::vector<CadModel> annotated = ReadCadFolder(cad, specs);
  AlignMeshes(cad, annotated);
  InstanceLibrary library = BuildLibrary(models, annotated, cad);
  if (!library.categories.empty()) return library;
  throw InputError(
      fmt::format("{}: has no annotated model of the categories {}; name others with --categories",
                  cad.string(), fmt::join(CategoryNames(models), ", ")));
}

fs::path IndexFile(const fs::path& library, const std::string& category) {
  fs::path file = library;
  file += "." + category + ".index";
  return file;
}

const InstanceRetrieval* OpenLibrary::Of(const std::string& category) const {
  for (const InstanceRetrieval& retrieval : retrievals) {
    if (retrieval.instances().category == category) return &retrieval;
  }
  return nullptr;
}

std::unique_ptr<OpenLibrary> OpenLibraryFile(const fs::path& file, const std::vector<CategoryModel>& models,
                                             const RetrievalOptions& options) {
  auto open = std::make_unique<OpenLibrary>();
  open->library = ReadLibrary(file, models);
  if (open->library.categories.empty()) {
    throw InputError(
        fmt::format("{}: has no instance of the categories {}; name the models it was built for with "
                    "--categories",
                    file.string(), fmt::join(CategoryNames(models), ", ")));
  }
  for (const CategoryInstances& instances : open->library.categories) {
    for (const CategoryModel& model : models) {
      if (model.spec.name != instances.category) continue;
      open->retrievals.emplace_back(model, instances, options, FindIndex(file, model, instances, options));
    }
  }
  return open;
}

}  // namespace armature
