// SPDX-License-Identifier: BSD-3-Clause
#include "eval/cad_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "category/normalise.h"
#include "eval/generated_cad.h"
#include "io/annotation_tables.h"
#include "io/annotations.h"
#include "io/errors.h"
#include "io/text.h"

namespace armature {
namespace {

struct CadSource {
  std::string category, prefix, format, annotations;
  std::string boxes;  // empty: there are none
  int boxes_id = 0;   // which column of it is the annotations' id
};

const std::vector<CadSource>& Sources() {
  static const std::vector<CadSource> sources = {
      {"chair", "keypointnet:", "keypointnet_chair", "keypointnet_chair_kp10.csv",
       "keypointnet_chair_boxes.txt", 0},
      {"table", "shapeassembly:", "shapeassembly_table", "shapeassembly_table_kp12.csv",
       "shapeassembly_table_boxes.txt", 1},
      {"laptop", "modelnet40:", "modelnet_laptop", "modelnet40_laptop_autokp6.csv", "", 0}};
  return sources;
}

Eigen::Matrix3d ObjectFrameOf(const std::string& format) {
  for (const AnnotationTable& table : AnnotationTables()) {
    if (table.format == format) return table.R_object_table;
  }
  return Eigen::Matrix3d::Identity();
}

struct Extent {
  Eigen::Vector3d min = Eigen::Vector3d::Constant(1e30);
  Eigen::Vector3d max = Eigen::Vector3d::Constant(-1e30);
};

// A line: two ids, then centre 3, half size 3, axes 9 (rows).
void AddBox(const std::filesystem::path& file, const TextLine& line, const CadSource& source,
            const Eigen::Matrix3d& R_object_table, std::map<std::string, Extent>& extents) {
  std::istringstream stream(line.text);
  std::array<std::string, 2> ids;
  Eigen::Matrix<double, 15, 1> v;
  stream >> ids[0] >> ids[1];
  for (double& value : v) stream >> value;
  if (!stream) {
    throw InputError(fmt::format("{}:{}: a box is two ids and 15 numbers: centre, half size, axes",
                                 file.string(), line.number));
  }
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(v.data() + 6);
  const Eigen::Vector3d center = R_object_table * v.head<3>();
  const Eigen::Vector3d half = (R_object_table * axes.transpose()).cwiseAbs() * v.segment<3>(3);
  Extent& extent = extents[ids[static_cast<size_t>(source.boxes_id)]];
  extent.min = extent.min.cwiseMin(center - half);
  extent.max = extent.max.cwiseMax(center + half);
}

std::map<std::string, Extent> ReadExtents(const std::filesystem::path& file, const CadSource& source) {
  std::map<std::string, Extent> extents;
  if (source.boxes.empty() || !std::filesystem::exists(file)) return extents;
  const Eigen::Matrix3d R_object_table = ObjectFrameOf(source.format);
  for (const TextLine& line : ReadTextLines(file)) AddBox(file, line, source, R_object_table, extents);
  return extents;
}

CadModel ModelOf(const Wireframe& wireframe, const Extent* extent) {
  if (extent) return {wireframe, extent->min, extent->max};
  const Eigen::Vector3d center = BoundingBoxCenter(wireframe), half = BoundingBoxSize(wireframe) / 2;
  return {wireframe, center - half, center + half};
}

}  // namespace

CadLibrary::CadLibrary(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs) {
  models_ = ReadGeneratedCad(folder, specs);
  bool found = !models_.empty();
  for (const CadSource& source : Sources()) {
    const std::filesystem::path file = folder / source.annotations;
    const auto spec = std::find_if(specs.begin(), specs.end(),
                                   [&](const CategorySpec& s) { return s.name == source.category; });
    if (spec == specs.end() || !std::filesystem::exists(file)) continue;
    found = true;
    const std::map<std::string, Extent> extents = ReadExtents(folder / source.boxes, source);
    for (const AnnotatedModel& model : ReadAnnotations(file, source.format, *spec)) {
      const auto extent = extents.find(model.id);
      models_[source.prefix + model.id] =
          ModelOf(model.wireframe, extent == extents.end() ? nullptr : &extent->second);
    }
  }
  if (!found) {
    throw InputError(fmt::format(
        "{}: has no annotated CAD models; give the folder of instances.csv, or of keypointnet_chair_kp10.csv",
        folder.string()));
  }
}

std::optional<Wireframe> CadLibrary::EdgesOf(const TrueObject& object) const {
  const auto found = models_.find(object.instance);
  if (found == models_.end()) return std::nullopt;
  return FittedToSize(found->second, object.size);
}

Wireframe FittedToSize(const CadModel& model, const Eigen::Vector3d& size) {
  const Eigen::Vector3d scale = size.cwiseQuotient(model.box_max - model.box_min);
  const Eigen::Vector3d center = (model.box_min + model.box_max) / 2;
  return {scale.asDiagonal() * (model.wireframe.midpoints.colwise() - center),
          scale.asDiagonal() * model.wireframe.directions};
}

}  // namespace armature
