// SPDX-License-Identifier: BSD-3-Clause
#include "truth/true_edges.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/microseconds.h"
#include "base/nearest_name.h"
#include "category/category_lookup.h"
#include "io/csv.h"

namespace armature {
namespace {

double TrueStamp(const CsvRow& row, const GroundTruth& truth) {
  const double timestamp = row.Number("timestamp");
  if (FindStamp(truth.T_world_camera, timestamp)) return timestamp;
  throw InputError(row.At(fmt::format(
      "no pose of groundtruth.txt is at {}; both files have to be of one sequence", row.Text("timestamp"))));
}

size_t ObjectIndex(const CsvRow& row, const GroundTruth& truth) {
  const auto object = std::find_if(truth.objects.begin(), truth.objects.end(),
                                   [&](const TrueObject& o) { return o.id == row.Text("id"); });
  if (object != truth.objects.end()) return static_cast<size_t>(object - truth.objects.begin());
  throw InputError(
      row.At(fmt::format("no object '{}' in objects_gt.csv; add it or remove the row", row.Text("id"))));
}

size_t EdgeIndex(const CsvRow& row, const CategorySpec& spec) {
  const auto edge = std::find(spec.edge_names.begin(), spec.edge_names.end(), row.Text("edge"));
  if (edge != spec.edge_names.end()) return static_cast<size_t>(edge - spec.edge_names.begin());
  throw InputError(row.At(fmt::format("a {} has an {}", spec.name,
                                      UnknownNameMessage("edge", row.Text("edge"), spec.edge_names))));
}

double VisibleShare(const CsvRow& row) {
  const double share = row.Number("visible");
  if (share >= 0 && share <= 1) return share;
  throw InputError(row.At(fmt::format("visible is {}; give the visible share, 0 to 1", row.Text("visible"))));
}

}  // namespace

TrueEdges::TrueEdges(const std::filesystem::path& file, const GroundTruth& truth,
                     const std::vector<CategorySpec>& specs) {
  std::vector<CategorySpec> spec_of;
  for (const TrueObject& object : truth.objects) spec_of.push_back(FindSpec(specs, object.category));
  for (const CategorySpec& spec : spec_of) edge_counts_.push_back(spec.edge_names.size());

  const CsvTable table(file, {"timestamp", "id", "edge", "x1", "y1", "x2", "y2", "visible"});
  for (const CsvRow& row : table.rows()) {
    const double timestamp = TrueStamp(row, truth);
    const size_t object = ObjectIndex(row, truth), edge = EdgeIndex(row, spec_of[object]);
    Rows& rows = rows_of_.try_emplace({Microseconds(timestamp), object}, edge_counts_[object]).first->second;
    if (rows[edge]) {
      throw InputError(row.At(fmt::format("edge '{}' of '{}' is at this time already in line {}; keep one",
                                          row.Text("edge"), row.Text("id"), rows[edge]->number)));
    }
    const Segment line{{row.Number("x1"), row.Number("y1")}, {row.Number("x2"), row.Number("y2")}};
    rows[edge] = Row{line, VisibleShare(row), row.line()};
  }
}

const TrueEdges::Rows* TrueEdges::Find(size_t object, double timestamp) const {
  const long long at = Microseconds(timestamp), tolerance = Microseconds(kStampTolerance);
  for (auto it = rows_of_.lower_bound({at - tolerance, 0});
       it != rows_of_.end() && it->first.first <= at + tolerance; ++it) {
    if (it->first.second == object) return &it->second;
  }
  return nullptr;
}

std::vector<VisibleEdge> TrueEdges::Seen(size_t object, double timestamp, double pixels_per_metre) const {
  std::vector<VisibleEdge> edges(edge_counts_[object]);
  const Rows* rows = Find(object, timestamp);
  for (size_t i = 0; rows && i < edges.size(); ++i) {
    const std::optional<Row>& row = (*rows)[i];
    if (row) edges[i] = EdgeSeenInPart(row->line, row->visible_share, pixels_per_metre);
  }
  return edges;
}

}  // namespace armature
