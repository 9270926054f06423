// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/cad/collection_files.h"

#include <fmt/format.h>

#include <map>

#include "base/csv_fields.h"
#include "base/interrupt.h"
#include "base/number_format.h"
#include "io/atomic_write.h"
#include "io/ply_text.h"

namespace armature {
namespace {

// After the point, metres. Learning takes what varies by a micrometre as a mode of the shape: the rounding
// must not.
constexpr int kDigits = 7;

std::string MeshName(const CadInstance& instance) {
  return fmt::format("{}/{}.ply", instance.category, instance.id);
}

std::string InstanceRow(const CadInstance& instance) {
  return fmt::format("{},{},{},{},{},{},{}\n", CsvField(instance.id), CsvField(instance.category),
                     instance.held_out ? 1 : 0, Fixed(instance.size.x(), kDigits),
                     Fixed(instance.size.y(), kDigits), Fixed(instance.size.z(), kDigits),
                     MeshName(instance));
}

std::string EdgeRows(const CadInstance& instance) {
  const std::vector<std::string> names = EdgeNames(instance.category);
  std::string rows;
  for (int edge = 0; edge < instance.wireframe.edges(); ++edge) {
    rows += fmt::format("{},{}", CsvField(instance.id), CsvField(names[static_cast<size_t>(edge)]));
    for (const int end : {0, 1}) {
      for (const double coordinate : instance.wireframe.End(edge, end)) {
        rows += ',' + Fixed(coordinate, kDigits);
      }
    }
    rows += "\n";
  }
  return rows;
}

}  // namespace

std::string CadPlyText(const Mesh& mesh) {
  return PlyText(MakeTriangles(mesh), PlyColours::kOfTriangles, "metres, y up, front +z");
}

void WriteCollection(const std::vector<CadInstance>& collection, const std::filesystem::path& folder) {
  std::string instances = "id,category,held_out,size_x,size_y,size_z,mesh\n";
  std::map<std::string, std::string> edges;  // by file
  for (const CadInstance& instance : collection) {
    ThrowIfInterrupted();
    instances += InstanceRow(instance);
    edges[instance.category + (instance.held_out ? "_edges_held_out.csv" : "_edges.csv")] +=
        EdgeRows(instance);
    std::error_code error;  // shows when the file in it cannot be written
    std::filesystem::create_directory(folder / instance.category, error);
    WriteFile(folder / MeshName(instance), CadPlyText(instance.mesh));
  }
  WriteFile(folder / "instances.csv", instances);
  for (const auto& [name, rows] : edges) WriteFile(folder / name, "model,edge,x1,y1,z1,x2,y2,z2\n" + rows);
}

}  // namespace armature
