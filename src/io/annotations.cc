// SPDX-License-Identifier: BSD-3-Clause
#include "io/annotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/errors.h"
#include "base/nearest_name.h"
#include "io/annotation_tables.h"
#include "io/csv.h"

namespace armature {
namespace {

Eigen::Vector3d Point(const CsvRow& row, const std::string& x, const std::string& y, const std::string& z) {
  return {row.Number(x), row.Number(y), row.Number(z)};
}

void SetEdge(const CsvRow& row, const std::string& name, const Eigen::Vector3d& start,
             const Eigen::Vector3d& end, Eigen::Index index, Wireframe& wireframe) {
  if (!((end - start).norm() > 0)) {
    throw InputError(row.At(fmt::format("edge '{}' has no length; its two ends are one point", name)));
  }
  wireframe.midpoints.col(index) = (start + end) / 2;
  wireframe.directions.col(index) = end - start;
}

Wireframe EmptyWireframe(const CategorySpec& spec) {
  return {Eigen::Matrix3Xd::Zero(3, spec.edges()), Eigen::Matrix3Xd::Zero(3, spec.edges())};
}

// The table's edges in the order of the specification.
std::vector<TableEdge> FindEdges(const AnnotationTable& table, const CategorySpec& spec) {
  std::vector<TableEdge> edges;
  for (const std::string& name : spec.edge_names) {
    const auto found = std::find_if(table.edges.begin(), table.edges.end(),
                                    [&](const TableEdge& edge) { return edge.name == name; });
    if (found == table.edges.end()) {
      throw InputError(
          fmt::format("format {} has no edge '{}' of category {}; give the category's own annotations in "
                      "format edges",
                      table.format, name, spec.name));
    }
    edges.push_back(*found);
  }
  return edges;
}

std::vector<AnnotatedModel> ReadTable(const std::filesystem::path& file, const AnnotationTable& table,
                                      const CategorySpec& spec) {
  const std::vector<TableEdge> edges = FindEdges(table, spec);
  const CsvTable csv(file, {table.id_column});
  std::vector<AnnotatedModel> models;
  for (const CsvRow& row : csv.rows()) {
    if (!table.filter_column.empty() && row.Integer(table.filter_column) != table.filter_value) continue;
    const auto point = [&](const std::string& name) -> Eigen::Vector3d {
      return table.R_object_table * Point(row, name + "_x", name + "_y", name + "_z");
    };
    AnnotatedModel model{row.Text(table.id_column), EmptyWireframe(spec)};
    for (size_t i = 0; i < edges.size(); ++i) {
      SetEdge(row, edges[i].name, point(edges[i].start), point(edges[i].end), static_cast<Eigen::Index>(i),
              model.wireframe);
    }
    models.push_back(std::move(model));
  }
  return models;
}

// A model of format `edges` while its rows are being read.
struct PartialModel {
  AnnotatedModel model;
  std::vector<int> lines;  // of each edge, 0: not seen
};

void AddEdgeRow(const CsvRow& row, const CategorySpec& spec, PartialModel& partial) {
  const std::string& name = row.Text("edge");
  const auto found = std::find(spec.edge_names.begin(), spec.edge_names.end(), name);
  if (found == spec.edge_names.end())
    throw InputError(row.At(UnknownNameMessage("edge", name, spec.edge_names)));
  const Eigen::Index index = found - spec.edge_names.begin();
  int& line = partial.lines[static_cast<size_t>(index)];
  if (line != 0) {
    throw InputError(row.At(
        fmt::format("model '{}' has edge '{}' already in line {}; keep one", partial.model.id, name, line)));
  }
  line = row.line();
  SetEdge(row, name, Point(row, "x1", "y1", "z1"), Point(row, "x2", "y2", "z2"), index,
          partial.model.wireframe);
}

void CheckComplete(const std::filesystem::path& file, const CategorySpec& spec, const PartialModel& partial) {
  const auto missing = std::find(partial.lines.begin(), partial.lines.end(), 0);
  if (missing == partial.lines.end()) return;
  const int last_line = *std::max_element(partial.lines.begin(), partial.lines.end());
  throw InputError(fmt::format(
      "{}:{}: model '{}' lacks edge '{}'; every model needs all {} edges", file.string(), last_line,
      partial.model.id, spec.edge_names[static_cast<size_t>(missing - partial.lines.begin())], spec.edges()));
}

std::vector<AnnotatedModel> ReadEdgeRows(const std::filesystem::path& file, const CategorySpec& spec) {
  const CsvTable csv(file, {"model", "edge", "x1", "y1", "z1", "x2", "y2", "z2"});
  std::vector<PartialModel> partials;
  std::map<std::string, size_t> index_of;
  for (const CsvRow& row : csv.rows()) {
    const auto [entry, is_new] = index_of.try_emplace(row.Text("model"), partials.size());
    if (is_new) {
      partials.push_back({{entry->first, EmptyWireframe(spec)}, std::vector<int>(spec.edge_names.size(), 0)});
    }
    AddEdgeRow(row, spec, partials[entry->second]);
  }
  std::vector<AnnotatedModel> models;
  for (PartialModel& partial : partials) {
    CheckComplete(file, spec, partial);
    models.push_back(std::move(partial.model));
  }
  return models;
}

}  // namespace

std::vector<std::string> AnnotationFormats() {
  std::vector<std::string> names = {"edges"};
  for (const AnnotationTable& table : AnnotationTables()) names.push_back(table.format);
  return names;
}

std::vector<AnnotatedModel> ReadAnnotations(const std::filesystem::path& file, const std::string& format,
                                            const CategorySpec& spec) {
  const std::vector<AnnotationTable>& tables = AnnotationTables();
  const auto table = std::find_if(tables.begin(), tables.end(), [&](const AnnotationTable& candidate) {
    return candidate.format == format;
  });
  if (table == tables.end() && format != "edges") {
    throw InputError(UnknownNameMessage("annotation format", format, AnnotationFormats()));
  }
  const std::vector<AnnotatedModel> models =
      format == "edges" ? ReadEdgeRows(file, spec) : ReadTable(file, *table, spec);
  if (models.empty()) throw InputError(fmt::format("{}: has no usable model", file.string()));
  return models;
}

}  // namespace armature
