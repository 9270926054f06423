// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/retrieved_models.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "base/text.h"
#include "io/csv.h"
#include "io/mesh_file.h"

namespace armature {
namespace {

RetrievedModel ReadModelRow(const CsvRow& row) {
  RetrievedModel model{row.Text("instance"), row.Number("distance"), {}, {}, 1};
  if (row.IsEmpty("cost")) return model;
  model.cost = row.Number("cost");
  model.T_world_object = ReadPose(row);
  model.scale = row.Number("scale");
  if (!(model.scale > 0)) throw InputError(row.At("column 'scale' is not positive; retrieve again"));
  return model;
}

}  // namespace

std::map<std::string, std::vector<RetrievedModel>> ReadRetrieval(const std::filesystem::path& run) {
  std::map<std::string, std::vector<RetrievedModel>> retrieved;
  const std::filesystem::path file = run / "retrieval.csv";
  if (!std::filesystem::exists(file)) return retrieved;
  const CsvTable table(file, {"object", "rank", "instance", "distance", "cost", "tx", "ty", "tz", "qx", "qy",
                              "qz", "qw", "scale"});
  for (const CsvRow& row : table.rows()) {
    std::vector<RetrievedModel>& models = retrieved[row.Text("object")];
    if (row.Integer("rank") != static_cast<int>(models.size()) + 1)
      throw InputError(row.At("ranks do not grow by one; retrieve again"));
    models.push_back(ReadModelRow(row));
  }
  return retrieved;
}

std::optional<TriangleMesh> LoadModelSurface(const InstanceLibrary& library, const std::string& category,
                                             const std::string& name) {
  const CategoryInstances* instances = library.Of(category);
  const int instance = instances == nullptr ? -1 : instances->Find(name);
  if (instance < 0 && library.categories.empty()) return std::nullopt;
  if (instance < 0) {
    throw InputError(fmt::format("the library has no {} {}; give the one that the run was retrieved with",
                                 category, Quoted(name)));
  }
  const std::string& geometry = instances->geometries[static_cast<size_t>(instance)];
  if (geometry.empty()) return std::nullopt;
  return Moved(instances->MakeTransform(instance), ReadGeometry(library.root / geometry));
}

}  // namespace armature
