// SPDX-License-Identifier: BSD-3-Clause
#include "app/reproduce/matrix_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/reproduce/job_records.h"

namespace armature {
namespace {

bool HasCells(const nlohmann::json& row, const EvaluatedNumbers::Where& cells) {
  return std::all_of(cells.begin(), cells.end(), [&](const auto& cell) {
    return row.value(cell.first, nlohmann::json()) == cell.second;
  });
}

// The rows of a variant in the tables of objects and trajectories; one placed by odometry has those of its
// run.
std::optional<double> ObjectNumber(const EvaluatedNumbers& numbers, const std::string& sequence,
                                   const Variant& variant, const std::string& column) {
  if (!variant.IsRun()) {
    return numbers.Of("objects", sequence,
                      {{"run", variant.odometry_of}, {"approach", "odometry only"}, {"category", "all"}},
                      column);
  }
  for (const char* approach : {"objects, loop closure", "objects, no loop closure"}) {
    const auto value = numbers.Of(
        "objects", sequence, {{"run", variant.name}, {"approach", approach}, {"category", "all"}}, column);
    if (value) return value;
  }
  return std::nullopt;
}

std::optional<double> CameraNumber(const EvaluatedNumbers& numbers, const std::string& sequence,
                                   const Variant& variant) {
  return numbers.Of("trajectory", sequence,
                    {{"run", variant.IsRun() ? variant.name : variant.odometry_of},
                     {"trajectory", variant.IsRun() ? "trajectory" : "odometry_scaled"},
                     {"alignment", "first_pose"}},
                    "ATE rmse [m]");
}

std::optional<double> ViewNumber(const EvaluatedNumbers& numbers, const std::string& sequence,
                                 const Variant& variant) {
  if (!variant.IsRun()) return std::nullopt;
  return numbers.Of("observations", sequence, {{"run", variant.name}, {"category", "all"}},
                    "within 15 deg [%]");
}

// What became of the job; one placed by odometry has that of its run.
std::string DescribeOutcome(const std::vector<JobRecord>& records, const Variant& variant,
                            const std::string& sequence) {
  const std::string name =
      fmt::format("runs/{}/{}", variant.IsRun() ? variant.name : variant.odometry_of, sequence);
  for (const JobRecord& record : records) {
    if (record.name != name) continue;
    return record.HasSucceeded() ? "done" : fmt::format("{}: {}", StatusName(record.status), record.reason);
  }
  return StatusName(JobStatus::kNotRun);
}

Cell Count(const std::optional<double>& value) { return value ? CountCell(std::lround(*value)) : NoCell(); }

std::vector<std::string> MatrixNotes() {
  return {
      "found, best, average, worst, spurious, azimuth: of the objects of the map against the true ones, as "
      "in the table of objects; cameras: rmse of their positions, the first pose aligned; views within 15 "
      "deg: share of all detections whose single view has the azimuth right.",
      "odometry only: the same run's objects, placed by the odometry alone with the map's scale and "
      "identities."};
}

// Of the draws of a family.
struct Spread {
  std::vector<double> values;

  double Mean() const {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
  std::optional<double> Deviation() const {
    if (values.size() < 2) return std::nullopt;
    double sum = 0;
    for (const double value : values) sum += (value - Mean()) * (value - Mean());
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
  }
};

void PushDraws(const Matrix& matrix, const EvaluatedNumbers& numbers, const std::string& scene,
               const Variant& variant, Table& table) {
  Spread error;
  double found = 0, of = 0, spurious = 0;
  for (const MatrixSequence& sequence : ListSequences(matrix)) {
    if (sequence.family != scene) continue;
    const auto average = ObjectNumber(numbers, sequence.name, variant, "average [m]");
    if (average) error.values.push_back(*average);
    found += ObjectNumber(numbers, sequence.name, variant, "found").value_or(0);
    of += ObjectNumber(numbers, sequence.name, variant, "observed").value_or(0);
    spurious += ObjectNumber(numbers, sequence.name, variant, "spurious").value_or(0);
  }
  auto& row = table.rows.emplace_back();
  row = {TextCell(scene), TextCell(variant.about), CountCell(static_cast<long>(error.values.size()))};
  if (error.values.empty()) {
    row.resize(table.columns.size(), NoCell());
    return;
  }
  const auto [least, most] = std::minmax_element(error.values.begin(), error.values.end());
  for (const Cell& cell :
       {NumberCell(error.Mean(), 4), NumberCell(error.Deviation(), 4), NumberCell(*least, 4),
        NumberCell(*most, 4), Count(found), Count(of), Count(spurious)})
    row.push_back(cell);
}

}  // namespace

std::optional<double> EvaluatedNumbers::Of(const std::string& table, const std::string& sequence,
                                           const Where& cells, const std::string& column) const {
  if (!eval_.is_object()) return std::nullopt;
  for (const auto& candidate : eval_.at("tables")) {
    if (candidate.value("table", "") != table || candidate.value("sequence", "") != sequence) continue;
    for (const auto& row : candidate.at("rows")) {
      if (!HasCells(row, cells)) continue;
      const auto number = row.find(column);
      if (number == row.end() || !number->is_number()) return std::nullopt;
      return number->get<double>();
    }
  }
  return std::nullopt;
}

Table MatrixTable(const Matrix& matrix, const std::vector<JobRecord>& records,
                  const EvaluatedNumbers& numbers) {
  Table table{.title = "Sequences and variants",
              .columns = {"sequence", "variant", "observed", "found", "spurious", "best [m]", "average [m]",
                          "worst [m]", "azimuth [deg]", "cameras [m]", "views within 15 deg [%]", "outcome"},
              .rows = {},
              .notes = MatrixNotes(),
              .name = "matrix"};
  for (const MatrixSequence& sequence : ListSequences(matrix)) {
    for (const Variant& variant : matrix.variants) {
      const auto of = [&](const char* column) {
        return ObjectNumber(numbers, sequence.name, variant, column);
      };
      table.rows.push_back({TextCell(sequence.name), TextCell(variant.about), Count(of("observed")),
                            Count(of("found")), Count(of("spurious")), NumberCell(of("best [m]"), 4),
                            NumberCell(of("average [m]"), 4), NumberCell(of("worst [m]"), 4),
                            NumberCell(of("azimuth [deg]"), 2),
                            NumberCell(CameraNumber(numbers, sequence.name, variant), 4),
                            NumberCell(ViewNumber(numbers, sequence.name, variant), 1),
                            TextCell(DescribeOutcome(records, variant, sequence.name))});
    }
  }
  return table;
}

std::optional<Table> DrawsTable(const Matrix& matrix, const EvaluatedNumbers& numbers) {
  if (matrix.seeds < 2 || matrix.scenes.empty()) return std::nullopt;
  Table table{
      .title = fmt::format("Objects' average error over {} draws of each scene [m]", matrix.seeds),
      .columns = {"scene", "variant", "draws", "mean", "spread", "least", "most", "found", "observed",
                  "spurious"},
      .rows = {},
      .notes = {"mean, spread: of the draws' average errors; spread: their standard deviation (n - 1). "
                "found, observed, spurious: sums. Each draw has other objects, clutter and noise."},
      .name = "draws"};
  for (const std::string& scene : matrix.scenes) {
    for (const Variant& variant : matrix.variants) PushDraws(matrix, numbers, scene, variant, table);
  }
  return table;
}

Table JobTable(const std::vector<JobRecord>& records) {
  Table table{
      .title = "Jobs",
      .columns = {"job", "outcome", "time [s]", "reason"},
      .rows = {},
      .notes = {"time: of its calls, when they were made; jobs run beside each other, those of timings and "
                "data alone. reused: an earlier run of the same program on the same inputs."},
      .name = "jobs"};
  for (const JobRecord& record : records) {
    table.rows.push_back({TextCell(record.name), TextCell(StatusName(record.status)),
                          record.seconds > 0 ? NumberCell(record.seconds, 1) : NoCell(),
                          TextCell(record.reason)});
  }
  return table;
}

}  // namespace armature
