// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/folder_collection.h"

#include <fmt/format.h>

#include <optional>
#include <set>

#include "base/errors.h"
#include "base/text.h"
#include "category/cad_model.h"
#include "category/kept_apart.h"
#include "category/normalise.h"
#include "cli/align_meshes.h"
#include "cli/data_folders.h"
#include "datasets/cad/published_meshes.h"
#include "geometry/random.h"
#include "io/cad_folder.h"
#include "io/category_yaml.h"
#include "io/mesh_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

const TrainingSpec& FindSpec(const std::vector<TrainingSpec>& specs, const std::string& category) {
  for (const TrainingSpec& spec : specs) {
    if (spec.category.name == category) return spec;
  }
  std::abort();  // ReadCadFolder leaves out what has no specification
}

// Metres a unit of the annotations; none where the reference measures nothing.
std::optional<double> FindUnit(const CadModel& model, const MetricReference& reference) {
  if (model.metric) return 1.0;
  const double measure = Measure(reference, model.wireframe);
  if (measure > 0) return reference.metres / measure;
  return std::nullopt;
}

// In metres, centred like the annotations' box.
Mesh ReadSurface(const CadModel& model, const fs::path& folder, double unit, std::uint64_t seed) {
  const Eigen::Affine3d T_object_annotation =
      Eigen::Scaling(unit) * Eigen::Translation3d(-(model.box_min + model.box_max) / 2);
  const FurnitureMaterials materials = DrawFurnitureMaterials(model.category, seed);
  const fs::path file = folder / model.geometry;
  if (const size_t mark = model.geometry.rfind('#'); mark != std::string::npos && !fs::exists(file)) {
    return BoxFurniture(folder / model.geometry.substr(0, mark), model.geometry.substr(mark + 1),
                        T_object_annotation * *model.T_annotation_geometry, materials);
  }
  const TriangleMesh mesh = ReadGeometry(file);
  const Eigen::Affine3d T_annotation_mesh = model.T_annotation_geometry
                                                ? *model.T_annotation_geometry
                                                : AlignedToAnnotations(mesh, model.wireframe);
  return TriangleFurniture(Moved(T_object_annotation * T_annotation_mesh, mesh), materials);
}

std::uint64_t IdSeed(const std::string& id) {
  std::uint64_t seed = 0;
  for (const char c : id) seed = StreamSeed(seed, static_cast<unsigned char>(c));
  return seed;
}

std::string FolderName(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

CadInstance MakeInstance(const CadModel& model, const TrainingSpec& spec, const fs::path& folder,
                         double unit) {
  const size_t colon = model.instance.find(':');
  CadInstance instance;
  instance.id = model.instance.substr(colon + 1);
  instance.category = model.category;
  instance.prefix = model.instance.substr(0, colon + 1);
  instance.collection = model.metric ? FolderName(folder) : model.instance.substr(0, colon);
  instance.size = unit * (model.box_max - model.box_min);
  const Eigen::Vector3d centre = (model.box_min + model.box_max) / 2;
  instance.wireframe = {unit * (model.wireframe.midpoints.colwise() - centre),
                        unit * model.wireframe.directions};
  instance.held_out =
      model.metric ? model.held_out
                   : IsKeptApart(instance.id) && spec.plausible.Contains(BoundingBoxSize(instance.wireframe));
  instance.read_mesh = [model, folder, unit, seed = IdSeed(instance.id)] {
    return ReadSurface(model, folder, unit, seed);
  };
  return instance;
}

}  // namespace

std::vector<TrainingSpec> FurnitureSpecs() {
  std::vector<TrainingSpec> specs;
  for (const char* name : {"chair.yaml", "table.yaml", "laptop.yaml"})
    specs.push_back(LoadTrainingSpec(ConfigsFolder({}) / "categories/specs" / name));
  return specs;
}

std::vector<CadInstance> ReadFolderCollection(const fs::path& folder,
                                              const std::vector<TrainingSpec>& specs) {
  std::vector<CategorySpec> categories;
  categories.reserve(specs.size());
  for (const TrainingSpec& spec : specs) categories.push_back(spec.category);
  std::vector<CadInstance> instances;
  for (const CadModel& model : ReadCadFolder(folder, categories)) {
    const TrainingSpec& spec = FindSpec(specs, model.category);
    const std::optional<double> unit = FindUnit(model, spec.category.reference);
    if (!model.geometry.empty() && unit) instances.push_back(MakeInstance(model, spec, folder, *unit));
  }
  return instances;
}

std::vector<CadInstance> CollectFurniture(std::vector<CadInstance> own,
                                          const std::vector<fs::path>& folders) {
  if (folders.empty()) return own;
  const std::vector<TrainingSpec> specs = FurnitureSpecs();
  std::set<std::string> names{"armature"};
  for (const fs::path& folder : folders) {
    std::set<std::string> more;
    for (CadInstance& instance : ReadFolderCollection(folder, specs)) {
      more.insert(instance.collection);
      own.push_back(std::move(instance));
    }
    for (const std::string& name : more) {
      if (names.insert(name).second) continue;
      throw InputError(
          fmt::format("--collection {}: a collection of the name {} is there already; rename "
                      "the folder, or leave one out",
                      folder.string(), Quoted(name)));
    }
  }
  return own;
}

}  // namespace armature
