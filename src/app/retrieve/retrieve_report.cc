// SPDX-License-Identifier: BSD-3-Clause
#include "app/retrieve/retrieve_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_format.h"

namespace armature {
namespace {

constexpr int kMostColumns = 5;

std::string InstanceText(const ObjectInstances& found, const RetrievedInstance& instance) {
  return fmt::format("{} ({})", found.library->ids[static_cast<size_t>(instance.instance)],
                     Fixed(instance.fit ? instance.fit->cost : instance.distance, 2));
}

std::string NumberMeaning(const RetrievalOptions& options) {
  if (options.rerank) {
    return "in brackets: what re-ranking orders by, the mean over the views of the cost of visible edges "
           "without segment and of the box; smaller is better";
  }
  if (options.covariance) {
    return "in brackets: distance from the estimated coefficients in standard deviations of their covariance";
  }
  return options.features.space == FeatureSpace::kRaw
             ? "in brackets: distance of the coefficients in metres"
             : "in brackets: distance of the coefficients in standard deviations";
}

}  // namespace

Table RetrievalTable(const std::vector<RunRetrieval>& runs, const RetrievalOptions& options) {
  const int columns = std::min(options.k, kMostColumns);
  Table table{.title = "Nearest CAD models", .columns = {"run", "object", "views"}, .rows = {}, .notes = {}};
  for (int i = 0; i < columns; ++i) table.columns.push_back(fmt::format("{}", i + 1));
  for (const RunRetrieval& run : runs) {
    for (const ObjectInstances& found : run.objects) {
      const MapObject& object = run.map.objects[found.object];
      std::vector<Cell> row{TextCell(run.sequence), TextCell(object.id), CountCell(object.observations)};
      for (size_t i = 0; i < static_cast<size_t>(columns); ++i) {
        row.push_back(i < found.instances.size() ? TextCell(InstanceText(found, found.instances[i]))
                                                 : NoCell());
      }
      table.rows.push_back(std::move(row));
    }
  }
  table.notes = {"views: detections that the map explains with the object", NumberMeaning(options)};
  if (options.k > kMostColumns)
    table.notes.push_back(fmt::format("the {} nearest of each are in retrieval.csv of the runs", options.k));
  return table;
}

Table LibraryTable(const InstanceLibrary& library) {
  Table table{.title = "Library of instances",
              .columns = {"category", "instances", "with surface", "coefficients"},
              .rows = {},
              .notes = {"with surface: has a mesh or boxes, which placing and surface distances need"}};
  for (const CategoryInstances& instances : library.categories) {
    const auto without = std::count(instances.geometries.begin(), instances.geometries.end(), "");
    table.rows.push_back({TextCell(instances.category), CountCell(instances.size()),
                          CountCell(instances.size() - without), CountCell(instances.coefficients.rows())});
  }
  return table;
}

}  // namespace armature
