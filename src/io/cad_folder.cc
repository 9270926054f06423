// SPDX-License-Identifier: BSD-3-Clause
#include "io/cad_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/interrupt.h"
#include "category/cad_model.h"
#include "category/normalise.h"
#include "io/annotation_tables.h"
#include "io/annotations.h"
#include "io/box_table.h"
#include "io/csv.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

using WireframesById = std::map<std::string, Wireframe>;

// The tables of edges, each read when the first instance in it is met.
class EdgeFiles {
 public:
  explicit EdgeFiles(fs::path folder) : folder_(std::move(folder)) {}

  const Wireframe& FindEdges(const CsvRow& instance, const CategorySpec& spec, bool held_out) {
    const std::string name = fmt::format("{}_edges{}.csv", spec.name, held_out ? "_held_out" : "");
    const WireframesById& wireframes = Read(name, spec);
    const auto found = wireframes.find(instance.Text("id"));
    if (found != wireframes.end()) return found->second;
    throw InputError(instance.At(
        fmt::format("'{}' has no edges in {}; generate the folder again", instance.Text("id"), name)));
  }

 private:
  const WireframesById& Read(const std::string& name, const CategorySpec& spec) {
    const auto [entry, is_new] = files_.try_emplace(name);
    if (!is_new) return entry->second;
    for (AnnotatedModel& model : ReadAnnotations(folder_ / name, "edges", spec))
      entry->second.emplace(std::move(model.id), std::move(model.wireframe));
    return entry->second;
  }

  fs::path folder_;
  std::map<std::string, WireframesById> files_;
};

bool IsHeldOut(const CsvRow& row) {
  const int held_out = row.Integer("held_out");
  if (held_out == 0 || held_out == 1) return held_out == 1;
  throw InputError(row.At(fmt::format("held_out is {}; give 0 or 1", held_out)));
}

Eigen::Vector3d ComputeSize(const CsvRow& row) {
  Eigen::Vector3d size(row.Number("size_x"), row.Number("size_y"), row.Number("size_z"));
  if ((size.array() > 0).all()) return size;
  throw InputError(row.At("a size is not positive; give metres along x, y and z"));
}

// instances.csv: `id,category,held_out,size_x,size_y,size_z,mesh`; sizes in metres, held_out 0 or 1, the mesh
// relative to the folder. The edges of an instance are in CATEGORY_edges.csv, CATEGORY_edges_held_out.csv for
// those held out, in format `edges` of annotations.h: metres, object frame. Instances are named
// "armature:ID"; in the order of the file; none when the folder has no instances.csv; categories without
// specification are left out. Throws InputError: a malformed file, an instance without edges, an id twice.
std::vector<CadModel> ReadGeneratedCad(const fs::path& folder, const std::vector<CategorySpec>& specs) {
  std::vector<CadModel> models;
  if (!fs::exists(folder / "instances.csv")) return models;
  EdgeFiles edges(folder);
  std::set<std::string> ids;
  const CsvTable table(folder / "instances.csv",
                       {"id", "category", "held_out", "size_x", "size_y", "size_z", "mesh"});
  for (const CsvRow& row : table.rows()) {
    const auto spec = std::find_if(specs.begin(), specs.end(),
                                   [&](const CategorySpec& s) { return s.name == row.Text("category"); });
    if (spec == specs.end()) continue;
    const Eigen::Vector3d half = ComputeSize(row) / 2;
    const bool held_out = IsHeldOut(row);
    models.push_back({.instance = "armature:" + row.Text("id"),
                      .category = spec->name,
                      .held_out = held_out,
                      .metric = true,
                      .wireframe = edges.FindEdges(row, *spec, held_out),
                      .box_min = -half,
                      .box_max = half,
                      .geometry = row.Text("mesh"),
                      .T_annotation_geometry = Eigen::Affine3d::Identity()});
    if (!ids.insert(row.Text("id")).second)
      throw InputError(row.At(fmt::format("'{}' is there twice; keep one row", row.Text("id"))));
  }
  return models;
}

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

Eigen::Matrix3d FindObjectFrame(const std::string& format) {
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
  const Eigen::Matrix3d R_annotation_table = FindObjectFrame(source.format);
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
    model.T_annotation_geometry = Eigen::Affine3d(FindObjectFrame(source.format));
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
    ThrowIfInterrupted();
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
