// SPDX-License-Identifier: BSD-3-Clause
#include "io/generated_cad.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "io/annotations.h"
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

}  // namespace

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

}  // namespace armature
