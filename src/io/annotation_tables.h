// SPDX-License-Identifier: BSD-3-Clause
// How published tables of key points, a row a model, become edges.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace armature {

struct TableEdge {
  std::string name;        // as in the category's specification
  std::string start, end;  // key points: columns START_x, START_y, START_z
};

struct AnnotationTable {
  std::string format;
  std::string id_column;
  std::string filter_column;  // empty: every row is used
  int filter_value = 0;       // rows with this value are used
  Eigen::Matrix3d R_object_table;
  std::vector<TableEdge> edges;
};

const std::vector<AnnotationTable>& AnnotationTables();

}  // namespace armature
