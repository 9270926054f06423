// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/detectors_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "bench/lines_engine.h"
#include "bench/sections/calibrated_race.h"
#include "bench/span_notes.h"
#include "bench/spans.h"

namespace armature {
namespace {

constexpr double kAccuracyMargin = 0.1;

const char* RegionName(const LineOptions& lines) { return lines.boxes_only ? "boxes" : "whole image"; }

std::vector<Cell> ChoiceCells(const DetectorChoice& choice) {
  return {TextCell(ToName(choice.lines.detector)), TextCell(choice.parameters),
          TextCell(RegionName(choice.lines))};
}

Contender MakeContender(const DetectorChoice& choice, LinesEngine& engine, const BenchTask& task,
                        Findings& findings) {
  Contender contender = MakeContender(choice.name, engine, task.sequence);
  contender.after = [&](BenchRow& row) {
    if (!task.truth.empty())
      AddFindings(task.truth[row.input], engine.last().segments, row.outcome.estimates, findings);
    row.outcome.estimates.clear();
  };
  return contender;
}

void RaceDetectors(const BenchTask& task, const std::vector<DetectorChoice>& choices,
                   std::vector<Findings>& findings, BenchSection& section) {
  std::vector<std::unique_ptr<LinesEngine>> engines;
  std::vector<Contender> contenders;
  findings.resize(choices.size());
  for (size_t i = 0; i < choices.size(); ++i) {
    Options options = task.parts.options;
    options.lines = choices[i].lines;
    engines.push_back(std::make_unique<LinesEngine>(options, task.parts.models));
    contenders.push_back(MakeContender(choices[i], *engines.back(), task, findings[i]));
  }
  RaceCalibrated(contenders, task.sequence.frames.size(), task.settings.harness, section);
}

std::optional<double> MedianSegments(const std::vector<BenchRow>& rows, const std::string& name) {
  std::vector<double> segments;
  for (const BenchRow& row : rows) {
    if (row.contender == name) segments.push_back(row.outcome.segments);
  }
  return ComputeMedian(segments);
}

Cell RecallCell(const EdgeRecall& recall) { return PercentCell(recall.covered, recall.visible); }

void AddAccuracy(const Findings& findings, std::vector<Cell>& row) {
  row.push_back(RecallCell(AllRecall(findings)));
  const auto accuracy = ComputeAccuracy(findings);
  if (!accuracy) {
    row.insert(row.end(), 4, NoCell());
    return;
  }
  row.push_back(NumberCell(accuracy->azimuth_deg, 2));
  row.push_back(NumberCell(100 * accuracy->within_15_deg, 1));
  row.push_back(NumberCell(accuracy->translation_percent, 2));
  row.push_back(NumberCell(100 * accuracy->with_pose, 1));
}

size_t FindLsd(const std::vector<DetectorChoice>& choices) {
  const auto found = std::find_if(choices.begin(), choices.end(), [](const DetectorChoice& choice) {
    return choice.lines.detector == LineDetectorKind::kLsd && !choice.lines.published &&
           !choice.lines.boxes_only;
  });
  return static_cast<size_t>(found - choices.begin());
}

std::vector<std::string> Notes(const BenchTask& task, const std::string& fastest) {
  std::vector<std::string> notes{ClockNote(task.settings)};
  notes.push_back(fmt::format(
      "n = {} runs each, of the whole pipeline with that detector and otherwise the given options.",
      (task.sequence.frames.size() - task.settings.harness.warm_up) * task.settings.harness.repetitions));
  notes.insert(
      notes.end(),
      {"lines: detection, dropping what is short, undistorting. total: the whole frame; on top: total less "
       "lines. an object: association and optimization over the frame's objects. Medians, lines also the "
       "90th percentile.",
       "half size: the tuned parameters on the image at half its size. segments: median an image. recall: "
       "see the next table, for which edges_gt.csv or CAD models (--cad) "
       "are needed.",
       "azimuth, translation: median errors of the poses of these frames' true objects, of the direction "
       "from which the camera sees the object and of |t - t_true| / |t_true|. within 15 deg, with pose: "
       "shares of the detections of true objects. Dashes without ground truth.",
       fastest.empty() ? "fastest of those whose accuracy is within 10 % of LSD's: not known without truth."
                       : fmt::format("Fastest (total) of those whose four numbers of accuracy are within 10 "
                                     "% of those of tuned LSD in the whole image: {}.",
                                     fastest)});
  return notes;
}

// The ways in which a detector can be set. Edgedrawing's tuned ones also as preset `fast` has them.
std::vector<std::pair<std::string, LineOptions>> ListParameters(LineDetectorKind detector,
                                                                LineOptions options) {
  options.detector = detector;
  options.published = false;
  std::vector<std::pair<std::string, LineOptions>> all{{"tuned", options}};
  if (detector == LineDetectorKind::kEdgeDrawing) {
    all.emplace_back("half size", options);
    all.back().second.edgedrawing_scale = 0.5;
  }
  all.emplace_back("published", options);
  all.back().second.published = true;
  return all;
}

}  // namespace

std::vector<DetectorChoice> DetectorChoices(const LineOptions& options) {
  std::vector<DetectorChoice> choices;
  for (const auto& [detector, name] : EnumNames<LineDetectorKind>::kTable) {
    for (const auto& [parameters, lines] : ListParameters(detector, options)) {
      for (const bool boxes_only : {false, true}) {
        DetectorChoice& choice = choices.emplace_back();
        choice.parameters = parameters;
        choice.lines = lines;
        choice.lines.boxes_only = boxes_only;
        choice.name = fmt::format("{} {} {}", name, parameters, RegionName(choice.lines));
      }
    }
  }
  return choices;
}

Table DetectorTable(const std::vector<DetectorChoice>& choices, const std::vector<BenchRow>& rows,
                    const std::vector<Findings>& findings) {
  Table table;
  table.columns = {"detector",      "parameters",        "lines in",        "lines [ms]",   "p90",
                   "on top [ms]",   "total [ms]",        "an object [ms]",  "segments",     "recall [%]",
                   "azimuth [deg]", "within 15 deg [%]", "translation [%]", "with pose [%]"};
  for (size_t i = 0; i < choices.size(); ++i) {
    const std::string& name = choices[i].name;
    const auto lines = ComputeStatistics(CollectDurations(rows, name, kBenchStageNames[0]));
    std::vector<Cell>& row = table.rows.emplace_back(ChoiceCells(choices[i]));
    row.push_back(lines ? NumberCell(lines->median, 2) : NoCell());
    row.push_back(lines ? NumberCell(lines->p90, 2) : NoCell());
    row.push_back(NumberCell(MedianDuration(rows, name, kOnTop), 2));
    row.push_back(NumberCell(MedianDuration(rows, name, kTotal), 2));
    row.push_back(NumberCell(ComputeMedian(DurationsAnObject(rows, name, kProcessing)), 3));
    row.push_back(NumberCell(MedianSegments(rows, name), 0));
    AddAccuracy(findings[i], row);
  }
  return table;
}

Table RecallTable(const std::vector<DetectorChoice>& choices, const std::vector<Findings>& findings) {
  std::set<std::string> categories;
  for (const Findings& f : findings) {
    for (const auto& [category, recall] : f.recall) categories.insert(category);
  }
  Table table;
  table.columns = {"detector", "parameters", "lines in", "n"};
  for (const std::string& category : categories) table.columns.push_back(category + " [%]");
  table.columns.push_back("all [%]");
  for (size_t i = 0; i < choices.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back(ChoiceCells(choices[i]));
    row.push_back(CountCell(findings[i].detections));
    for (const std::string& category : categories) {
      const auto found = findings[i].recall.find(category);
      row.push_back(found == findings[i].recall.end() ? NoCell() : RecallCell(found->second));
    }
    row.push_back(RecallCell(AllRecall(findings[i])));
  }
  const EdgeTolerance tolerance;
  table.notes = {fmt::format(
      "n: detections of true objects. Share of the length of their own edges, in the image and not hidden, "
      "beside which some segment runs within {} px and {} degrees; by edges_gt.csv or CAD models (--cad).",
      tolerance.distance, tolerance.angle_deg)};
  return table;
}

int FastestAsAccurateAsLsd(const std::vector<DetectorChoice>& choices, const std::vector<BenchRow>& rows,
                           const std::vector<Findings>& findings) {
  const auto reference = ComputeAccuracy(findings[FindLsd(choices)]);
  int fastest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < choices.size() && reference; ++i) {
    const auto accuracy = ComputeAccuracy(findings[i]);
    const auto total = MedianDuration(rows, choices[i].name, kTotal);
    if (!accuracy || !total || *total >= least || !IsAsAccurate(*accuracy, *reference, kAccuracyMargin))
      continue;
    least = *total;
    fastest = static_cast<int>(i);
  }
  return fastest;
}

BenchSection DetectorsSection(const BenchTask& task) {
  BenchSection section{.name = "detectors", .sequence = task.sequence.name};
  const std::vector<DetectorChoice> choices = DetectorChoices(task.parts.options.lines);
  std::vector<Findings> findings;
  RaceDetectors(task, choices, findings, section);
  std::vector<std::string> names;
  for (const DetectorChoice& choice : choices) names.push_back(choice.name);
  section.spans = CollectSpans(section.name, section.sequence, section.rows, names);
  section.tables = {DetectorTable(choices, section.rows, findings)};
  const int fastest = FastestAsAccurateAsLsd(choices, section.rows, findings);
  section.tables[0].notes = Notes(task, fastest < 0 ? "" : names[static_cast<size_t>(fastest)]);
  section.tables[0].title = task.sequence.name + ": line detectors, time and accuracy";
  if (AllRecall(findings.front()).visible <= 0) return section;
  section.tables.push_back(RecallTable(choices, findings));
  section.tables.back().title = task.sequence.name + ": line detectors, recall of true edges";
  return section;
}

}  // namespace armature
