// SPDX-License-Identifier: BSD-3-Clause
#include "eval/views/evaluation_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/csv_fields.h"
#include "base/number_format.h"

namespace armature {
namespace {

struct Selection {
  int detections = 0;  // with truth
  int ok = 0;
  std::vector<ObservationError> errors;  // of those with an estimate (and, in the second table, status ok)
  MatchCounts matches;
};

Selection Select(const RunEvaluation& evaluation, const std::string& category, bool only_ok) {
  Selection s;
  for (const EvaluatedDetection& d : evaluation.detections) {
    if (!category.empty() && d.category != category) continue;
    ++s.detections;
    s.ok += d.status == "ok" ? 1 : 0;
    if (only_ok && d.status != "ok") continue;
    if (d.error) s.errors.push_back(*d.error);
    if (d.matches) s.matches += *d.matches;
  }
  return s;
}

std::optional<double> Share(long part, long whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

ViewRecord MakeViewRecord(const std::string& sequence, const NamedEvaluation& run,
                          const std::optional<std::string>& category, bool only_ok) {
  const Selection s = Select(run.evaluation, category.value_or(""), only_ok);
  const ObservationSummary summary = Summarise(s.errors);
  const auto median = [&](double value) { return summary.count > 0 ? std::optional(value) : std::nullopt; };
  const long within_15_deg = std::lround(summary.share_within_15_deg * summary.count);
  return {.sequence = sequence,
          .run = run.run,
          .category = category,
          .only_ok = only_ok,
          .detections = s.detections,
          .estimates = summary.count,
          .ok = s.ok,
          .azimuth_median_deg = median(summary.median_azimuth_deg),
          .views_within_15_deg_share = Share(within_15_deg, only_ok ? summary.count : s.detections),
          .translation_median_percent = median(summary.median_translation_percent),
          .distance_median_percent = median(summary.median_distance_percent),
          .up_axis_median_deg = median(summary.median_axis_deg),
          .matches = s.matches.matches,
          .visible_edges = s.matches.visible_edges,
          .match_precision_share = Share(s.matches.on_edge.matches, s.matches.matches),
          .match_recall_share = Share(s.matches.on_edge.edges, s.matches.visible_edges),
          .near_match_precision_share = Share(s.matches.near_edge.matches, s.matches.matches),
          .near_match_recall_share = Share(s.matches.near_edge.edges, s.matches.visible_edges)};
}

std::vector<ViewRecord> MakeRecords(const std::string& sequence, const std::vector<NamedEvaluation>& runs,
                                    bool only_ok) {
  std::vector<ViewRecord> records;
  const std::vector<std::string> categories = ListCategories(runs);
  for (const NamedEvaluation& run : runs) {
    for (const std::string& category : categories)
      records.push_back(MakeViewRecord(sequence, run, category, only_ok));
    records.push_back(MakeViewRecord(sequence, run, std::nullopt, only_ok));
  }
  return records;
}

std::vector<Cell> MakeRow(const ViewRecord& r) {
  std::vector<Cell> row{TextCell(r.run), TextCell(r.category.value_or("all")), CountCell(r.detections),
                        CountCell(r.estimates)};
  if (!r.only_ok) row.push_back(PercentCell(static_cast<double>(r.ok), static_cast<double>(r.detections)));
  row.push_back(NumberCell(r.azimuth_median_deg, 2));
  row.push_back(ShareCell(r.views_within_15_deg_share, r.only_ok ? r.estimates : r.detections));
  row.push_back(NumberCell(r.translation_median_percent, 2));
  row.push_back(NumberCell(r.distance_median_percent, 2));
  row.push_back(NumberCell(r.up_axis_median_deg, 2));
  row.push_back(ShareCell(r.match_precision_share, r.matches));
  row.push_back(ShareCell(r.match_recall_share, r.visible_edges));
  row.push_back(ShareCell(r.near_match_precision_share, r.matches));
  row.push_back(ShareCell(r.near_match_recall_share, r.visible_edges));
  return row;
}

// Lines of the note under the first table.
std::vector<std::string> Definitions(bool true_edges) {
  const std::string own_edges =
      true_edges
          ? "precision, recall: own edges as edges_gt.csv has them, see the table of edges."
          : "precision, recall: of objects with a known CAD model (--cad); a dash where there is none.";
  return {
      "detections: those of a true object. estimates: those of them with a pose, whatever the status.",
      "azimuth, translation, distance, up axis: medians over the estimates.",
      "azimuth: of the camera seen from the object, each along its own ray; symmetric turns are equal.",
      "within 15 deg: share of the detections with at most that azimuth error; one without pose is not.",
      "translation: |t - t_true| / |t_true|. distance: signed, (|t| - |t_true|) / |t_true|.",
      "up axis: angle between the estimated and the true y axis.",
      fmt::format(
          "precision: share of the matches whose segment is on the object's own edge of that name: both "
          "ends within {} px of its line, at most {} degrees apart, side by side.",
          kOnEdge.distance, kOnEdge.angle_deg),
      fmt::format(
          "recall: share of the own edges with at least {} px in the image and not hidden that have such a "
          "match; without pose none has.",
          kLeastVisiblePixels),
      fmt::format("~: the same within {} px and {} cm: legs and posts are annotated along their axes.",
                  kNearEdge.distance, 100 * kNearEdge.metres),
      own_edges};
}

std::vector<std::string> Notes(const std::vector<NamedEvaluation>& runs, bool only_ok) {
  if (only_ok)
    return {"As above, but estimates are those with status ok, and all shares are of them and their edges."};
  std::vector<std::string> notes = Definitions(HaveTrueEdges(runs));
  for (const NamedEvaluation& run : runs) {
    if (run.evaluation.without_truth == 0) continue;
    notes.push_back(fmt::format("{}: {} detections are of no true object and are left out.", run.run,
                                run.evaluation.without_truth));
  }
  return notes;
}

Table MakeTable(const std::string& sequence, const std::vector<NamedEvaluation>& runs, bool only_ok) {
  Table table;
  table.title = sequence + (only_ok ? ": estimates with status ok" : ": all estimates");
  table.name = only_ok ? "observations_ok" : "observations";
  table.sequence = sequence;
  table.columns = {"run", "category", "detections", "estimates"};
  if (!only_ok) table.columns.push_back("ok [%]");
  for (const char* column :
       {"azimuth [deg]", "within 15 deg [%]", "translation [%]", "distance [%]", "up axis [deg]",
        "precision [%]", "recall [%]", "~precision [%]", "~recall [%]"}) {
    table.columns.push_back(column);
  }
  for (const ViewRecord& record : MakeRecords(sequence, runs, only_ok)) table.rows.push_back(MakeRow(record));
  table.notes = Notes(runs, only_ok);
  return table;
}

std::string RawRow(const std::string& run, const std::string& sequence, const EvaluatedDetection& d) {
  std::string row =
      fmt::format("{},{},{},{},{},{},{}", CsvField(run), CsvField(sequence), Fixed(d.timestamp, 6), d.index,
                  CsvField(d.object), CsvField(d.category), CsvField(d.status));
  row += d.error ? fmt::format(",{},{},{},{},{},{}", Fixed(d.error->azimuth_deg, 4),
                               Fixed(d.error->translation_percent, 4), Fixed(d.error->distance_percent, 4),
                               Fixed(d.error->elevation_axis_deg, 4), Fixed(d.error->pitch_deg, 4),
                               Fixed(d.error->roll_deg, 4))
                 : ",,,,,,";
  if (!d.matches) return row + ",,,,,,\n";
  const MatchCounts& m = *d.matches;
  return row + fmt::format(",{},{},{},{},{},{}\n", m.matches, m.visible_edges, m.on_edge.matches,
                           m.on_edge.edges, m.near_edge.matches, m.near_edge.edges);
}

}  // namespace

std::vector<ViewRecord> MakeViewRecords(const std::string& sequence,
                                        const std::vector<NamedEvaluation>& runs) {
  std::vector<ViewRecord> records = MakeRecords(sequence, runs, false);
  for (ViewRecord& record : MakeRecords(sequence, runs, true)) records.push_back(std::move(record));
  return records;
}

std::vector<std::string> ListCategories(const std::vector<NamedEvaluation>& runs) {
  std::set<std::string> categories;
  for (const NamedEvaluation& run : runs) {
    for (const EvaluatedDetection& d : run.evaluation.detections) categories.insert(d.category);
  }
  return {categories.begin(), categories.end()};
}

bool HaveTrueEdges(const std::vector<NamedEvaluation>& runs) {
  return std::any_of(runs.begin(), runs.end(),
                     [](const NamedEvaluation& run) { return run.evaluation.has_true_edges; });
}

std::vector<Table> EvaluationTables(const std::string& sequence, const std::vector<NamedEvaluation>& runs) {
  return {MakeTable(sequence, runs, false), MakeTable(sequence, runs, true)};
}

std::string RawCsv(const std::vector<NamedEvaluation>& runs) {
  std::string text =
      "run,sequence,timestamp,index,object,category,status,azimuth_error_deg,translation_error_percent,"
      "distance_error_percent,up_axis_error_deg,pitch_error_deg,roll_error_deg,matches,visible_edges,"
      "right_matches,found_edges,near_matches,near_edges\n";
  for (const NamedEvaluation& run : runs) {
    for (const EvaluatedDetection& d : run.evaluation.detections)
      text += RawRow(run.run, run.evaluation.sequence, d);
  }
  return text;
}

}  // namespace armature
