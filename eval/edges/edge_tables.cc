// SPDX-License-Identifier: BSD-3-Clause
#include "eval/edges/edge_tables.h"

#include <fmt/format.h>

#include "base/csv_fields.h"
#include "base/number_format.h"

namespace armature {
namespace {

struct CategoryCounts {
  int detections = 0;  // with truth
  MatchCounts counts;
};

CategoryCounts CountMatches(const RunEvaluation& evaluation, const std::string& category) {
  CategoryCounts s;
  for (const EvaluatedDetection& d : evaluation.detections) {
    if (!category.empty() && d.category != category) continue;
    ++s.detections;
    if (d.matches) s.counts += *d.matches;
  }
  return s;
}

std::vector<Cell> MakeRow(const NamedEvaluation& run, const std::string& category) {
  const auto& [detections, counts] = CountMatches(run.evaluation, category);
  std::vector<Cell> row{TextCell(run.run), TextCell(category.empty() ? "all" : category)};
  row.push_back(CountCell(detections));
  row.push_back(CountCell(counts.matches));
  row.push_back(CountCell(counts.visible_edges));
  for (const RightMatches* right : {&counts.on_edge, &counts.near_edge}) {
    row.push_back(PercentCell(right->matches, counts.matches));
    row.push_back(PercentCell(right->edges, counts.visible_edges));
    row.push_back(PercentCell(right->match_length, counts.match_length));
    row.push_back(PercentCell(right->covered_length, counts.visible_length));
  }
  if (category.empty()) {
    row.push_back(CountCell(run.evaluation.false_alarms));
    row.push_back(PercentCell(run.evaluation.trusted_false_alarms, run.evaluation.false_alarms));
  } else {
    row.insert(row.end(), 2, NoCell());  // an alarm by nothing is of no category
  }
  return row;
}

std::vector<std::string> Definitions() {
  return {
      "detections: those of a true object. matches: rows of associations.csv of those of them with a pose, "
      "whatever its status.",
      fmt::format(
          "true edges: those of the detected objects with at least {} px in the image and not hidden; by "
          "edges_gt.csv also with at least {:g} % of their part in the image not hidden.",
          kLeastVisiblePixels, 100 * kLeastVisibleShare),
      fmt::format(
          "precision: share of the matches that are right: on the object's true edge of that name, under "
          "the nearest symmetric turn. Both ends within {:g} px of its line, at most {:g} degrees apart, "
          "side by side. By edges_gt.csv a match on an edge of which nothing is visible is wrong.",
          kOnEdge.distance, kOnEdge.angle_deg),
      "recall: share of the true edges that have a right match; without pose none has.",
      "precision by length: each match counts by its segment's length. recall by length: share of the true "
      "edges' visible length beside which segments of right matches of the same edge run.",
      fmt::format("~: the same within {:g} px and {:g} cm.", kNearEdge.distance, 100 * kNearEdge.metres),
      "false alarms: detections of no object, of whatever category. false alarms ok: share of them that got "
      "a pose with status ok."};
}

std::vector<std::string> Notes(const std::vector<NamedEvaluation>& runs) {
  std::vector<std::string> notes = Definitions();
  if (HaveTrueEdges(runs)) {
    notes.push_back(
        "Truth: edges_gt.csv, visible by ray casting; centimetres at the depth of the object's centre.");
  } else {
    notes.push_back("Truth: CAD models (--cad), hidden by faces only; a dash where there is none.");
  }
  return notes;
}

std::string RawRow(const std::string& start, const JudgedMatch& match) {
  return fmt::format("{},{},{},{},{},{},{}\n", start, CsvField(match.edge), CsvField(match.true_edge),
                     match.on_edge ? 1 : 0, match.near_edge ? 1 : 0,
                     match.distance ? Fixed(*match.distance, 3) : "", Fixed(match.length, 3));
}

}  // namespace

Table EdgeTable(const std::string& sequence, const std::vector<NamedEvaluation>& runs) {
  Table table;
  table.title = sequence + ": matches of edges and segments";
  table.name = "edges";
  table.sequence = sequence;
  table.columns = {"run", "category", "detections", "matches", "true edges"};
  for (const std::string prefix : {"", "~"}) {
    for (const char* column :
         {"precision [%]", "recall [%]", "precision by length [%]", "recall by length [%]"})
      table.columns.push_back(prefix + column);
  }
  table.columns.push_back("false alarms");
  table.columns.push_back("false alarms ok [%]");
  std::vector<std::string> categories = ListCategories(runs);
  categories.push_back("");  // all
  for (const NamedEvaluation& run : runs) {
    for (const std::string& category : categories) table.rows.push_back(MakeRow(run, category));
  }
  table.notes = Notes(runs);
  return table;
}

std::string RawEdgesCsv(const std::vector<NamedEvaluation>& runs) {
  std::string text =
      "run,sequence,timestamp,index,object,category,edge,true_edge,right,near,distance_px,length_px\n";
  for (const NamedEvaluation& run : runs) {
    for (const EvaluatedDetection& d : run.evaluation.detections) {
      const std::string start =
          fmt::format("{},{},{},{},{},{}", CsvField(run.run), CsvField(run.evaluation.sequence),
                      Fixed(d.timestamp, 6), d.index, CsvField(d.object), CsvField(d.category));
      for (const JudgedMatch& match : d.judged) text += RawRow(start, match);
    }
  }
  return text;
}

}  // namespace armature
