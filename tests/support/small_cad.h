// SPDX-License-Identifier: BSD-3-Clause
// A folder as `armature generate` writes its CAD models to, of two tables, without meshes.
#pragma once

#include <fmt/format.h>

#include <string>

#include "category/category_model.h"
#include "support/temp_folder.h"

namespace armature::testing {

// All edges of the category, the i-th from (x, 0, 0) to (x, 1, 0) with x = i + shift.
inline std::string FindEdges(const std::string& model, const CategorySpec& spec, double shift) {
  std::string rows;
  for (int i = 0; i < spec.edges(); ++i) {
    const double x = i + shift;
    rows += fmt::format("{},{},{},0,0,{},1,0\n", model, spec.edge_names[static_cast<size_t>(i)], x, x);
  }
  return rows;
}

inline void WriteInstances(const TempFolder& folder, const std::string& rows) {
  folder.Write("instances.csv", "id,category,held_out,size_x,size_y,size_z,mesh\n" + rows);
}

// table-0001, and table-0010, which is held out and has its edges shifted by 0.5.
inline void WriteSmallCad(const TempFolder& folder, const CategorySpec& table) {
  const std::string header = "model,edge,x1,y1,z1,x2,y2,z2\n";
  WriteInstances(folder,
                 "table-0001,table,0,1.2,0.7,0.6,mesh/a.ply\ntable-0010,table,1,2,0.7,0.6,mesh/b.ply\n");
  folder.Write("table_edges.csv", header + FindEdges("table-0001", table, 0));
  folder.Write("table_edges_held_out.csv", header + FindEdges("table-0010", table, 0.5));
}

}  // namespace armature::testing
