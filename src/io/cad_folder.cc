// SPDX-License-Identifier: BSD-3-Clause
#include "io/cad_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/errors.h"
#include "category/normalise.h"
#include "io/annotation_tables.h"
#include "io/annotations.h"
#include "io/box_table.h"
#include "io/generated_cad.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Published tables of key points and what there is of their models' surfaces.
struct CadSource {
  std::string category, prefix, format, annotations;
  std::string boxes;   // a table of boxes; empty: there is none
  size_t boxes_id;     // which id of a box is the annotations'
  std::string meshes;  // a folder of meshes named as the models; empty: there is none
};

const std::vector<CadSource>& Sources() {
  static const std::vector<CadSource> sources = {
      {"chair", "keypointnet:", "keypointnet_chair", "keypointnet_chair_kp10.csv",
       "keypointnet_chair_boxes.txt", 0, ""},
      {"table", "shapeassembly:", "shapeassembly_table", "shapeassembly_table_kp12.csv",
       "shapeassembly_table_boxes.txt", 1, ""},
      {"laptop", "modelnet40:", "modelnet_laptop", "modelnet40_laptop_autokp6.csv", "", 0,
       "modelnet40_laptop"}};
  return sources;
}

Eigen::Matrix3d ObjectFrameOf(const std::string& format) {
  for (const AnnotationTable& table : AnnotationTables()) {
    if (table.format == format) return table.R_object_table;
  }
  return Eigen::Matrix3d::Identity();
}

using Extents = std::map<std::string, Eigen::AlignedBox3d>;  // by id, in the frame of the annotations

Extents ReadExtents(const fs::path& folder, const CadSource& source) {
  Extents extents;
  const fs::path file = folder / source.boxes;
  if (source.boxes.empty() || !fs::exists(file)) return extents;
  const Eigen::Matrix3d R_annotation_table = ObjectFrameOf(source.format);
  for (const TextLine& line : ReadTextLines(file)) {
    const TableBox box = ParseTableBox(file, line);
    const Eigen::Vector3d centre = R_annotation_table * box.centre;
    const Eigen::Vector3d half = (R_annotation_table * box.half_axes).cwiseAbs().rowwise().sum();
    extents[box.ids[source.boxes_id]].extend(Eigen::AlignedBox3d(centre - half, centre + half));
  }
  return extents;
}

CadModel LookUpModel(const CadSource& source, const AnnotatedModel& annotated, const fs::path& folder,
                     const Extents& extents) {
  CadModel model{.instance = source.prefix + annotated.id,
                 .category = source.category,
                 .wireframe = annotated.wireframe};
  if (const auto boxes = extents.find(annotated.id); boxes != extents.end()) {
    model.box_min = boxes->second.min();
    model.box_max = boxes->second.max();
    model.geometry = source.boxes + "#" + annotated.id;
    model.T_annotation_geometry = Eigen::Affine3d(ObjectFrameOf(source.format));
    return model;
  }
  const Eigen::Vector3d centre = BoundingBoxCenter(model.wireframe),
                        half = BoundingBoxSize(model.wireframe) / 2;
  model.box_min = centre - half;
  model.box_max = centre + half;
  const fs::path mesh = fs::path(source.meshes) / annotated.id;
  if (!source.meshes.empty() && fs::exists(folder / mesh)) model.geometry = mesh.string();
  return model;
}

std::vector<CadModel> ReadSource(const fs::path& folder, const CadSource& source, const CategorySpec& spec) {
  const Extents extents = ReadExtents(folder, source);
  std::map<std::string, CadModel> by_name;
  for (const AnnotatedModel& annotated : ReadAnnotations(folder / source.annotations, source.format, spec)) {
    CadModel model = LookUpModel(source, annotated, folder, extents);
    by_name[model.instance] = std::move(model);
  }
  std::vector<CadModel> models;
  models.reserve(by_name.size());
  for (auto& [name, model] : by_name) models.push_back(std::move(model));
  return models;
}

}  // namespace

std::vector<CadModel> ReadCadFolder(const fs::path& folder, const std::vector<CategorySpec>& specs) {
  std::vector<CadModel> models = ReadGeneratedCad(folder, specs);
  bool found = fs::exists(folder / "instances.csv");
  for (const CadSource& source : Sources()) {
    const auto spec = std::find_if(specs.begin(), specs.end(),
                                   [&](const CategorySpec& s) { return s.name == source.category; });
    if (spec == specs.end() || !fs::exists(folder / source.annotations)) continue;
    found = true;
    for (CadModel& model : ReadSource(folder, source, *spec)) models.push_back(std::move(model));
  }
  if (!found) {
    throw InputError(fmt::format(
        "{}: has no annotated CAD models; give the folder of instances.csv, or of keypointnet_chair_kp10.csv",
        folder.string()));
  }
  return models;
}

}  // namespace armature
