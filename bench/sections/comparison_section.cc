// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/comparison_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "base/paper_figures.h"
#include "bench/bench_sequence.h"
#include "bench/sections/calibrated_race.h"
#include "bench/span_notes.h"
#include "bench/spans.h"

namespace armature {
namespace {

void RaceEngines(const BenchTask& task, BenchSection& section) {
  const BenchSequence& sequence = task.sequence;
  const BenchSettings& settings = task.settings;
  const auto is_used = [&](size_t input) {
    return sequence.frames[input].input.detections.size() == settings.objects;
  };
  std::vector<std::unique_ptr<Engine>> engines;
  std::vector<Contender> contenders;
  for (const std::string& name : settings.engines) {
    engines.push_back(MakeEngine(name, task.parts));
    contenders.push_back(MakeContender(name, *engines.back(), sequence));
    contenders.back().after = [](BenchRow& row) { row.outcome.estimates.clear(); };
    if (!engines.back()->IsStateless()) continue;
    contenders.back().wants = PickOne(
        SparseInputs(is_used, sequence.frames.size(), settings.harness.warm_up, settings.baseline_frames));
  }
  RaceCalibrated(contenders, sequence.frames.size(), settings.harness, section);
}

Cell PaperLinesCell(std::string_view span, double objects) {
  if (span == kBenchStageNames[0]) return NumberCell(paper::kLineDetectionMs, 2);
  if (span == kProcessing) return NumberCell(objects * paper::kLinesPerObjectMs, 2);
  return span == kTotal ? NumberCell(paper::LinesMs(objects), 2) : NoCell();
}

Cell PaperKeypointsCell(std::string_view span, double objects) {
  const bool is_known = span == kBenchStageNames[0] || span == kTotal;
  return is_known ? NumberCell(paper::KeypointsMs(objects), 2) : NoCell();
}

void AddNotes(const BenchTask& task, const std::vector<BenchRow>& rows, Table& table) {
  table.notes.push_back(ClockNote(task.settings));
  for (std::string& note : StageNotes()) table.notes.push_back(std::move(note));
  for (std::string& note : EngineNotes(task.settings.engines, task.parts))
    table.notes.push_back(std::move(note));
  std::vector<std::string> counts;
  for (const std::string& engine : task.settings.engines)
    counts.push_back(fmt::format("{} {}", engine, CollectDurations(rows, engine, kTotal).size()));
  table.notes.push_back(fmt::format(
      "n, frames with exactly {} objects: {}. All frames are processed by what remembers them; a baseline "
      "takes part only in every so many of these. What follows it there may be slower, for the machine has "
      "slept or its caches hold the network: that is in the 90th and 99th percentiles of the others.",
      task.settings.objects, fmt::join(counts, ", ")));
  table.notes.push_back(
      "paper: as printed in its section 4, on an i5 and a Titan X, for 856x480 and 3 objects; it does not "
      "split its 120 ms an object. Its hardware is not ours: compare the ratios.");
}

}  // namespace

void CheckHasComparedFrames(const std::string& sequence, const std::vector<size_t>& objects,
                            const BenchSettings& settings) {
  const size_t warm_up = settings.harness.warm_up;
  if (objects.size() <= warm_up) return;  // the race says so
  std::set<size_t> counts(objects.begin() + static_cast<std::ptrdiff_t>(warm_up), objects.end());
  counts.erase(0);
  if (counts.contains(settings.objects)) return;
  throw InputError(
      fmt::format("{}: no frame after the warm-up of {} has exactly {} objects (there are: {}); choose with "
                  "--objects",
                  sequence, warm_up, settings.objects,
                  counts.empty() ? "none with any" : fmt::format("{}", fmt::join(counts, ", "))));
}

Table StageTable(const std::vector<BenchRow>& rows, const std::vector<std::string>& engines, size_t objects) {
  Table table;
  table.columns = {"stage"};
  for (const std::string& engine : engines) table.columns.push_back(engine + " [ms]");
  table.columns.insert(table.columns.end(), {"paper: lines [ms]", "paper: keypoints [ms]"});
  std::vector<std::string_view> spans(kBenchStageNames.begin(), kBenchStageNames.end());
  spans.insert(spans.end(), {kOther, kTotal});
  spans.insert(spans.begin() + 3, kProcessing);
  for (const std::string_view span : spans) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.push_back(TextCell(std::string(span)));
    for (const std::string& engine : engines)
      row.push_back(NumberCell(MedianDuration(rows, engine, span), 3));
    row.push_back(PaperLinesCell(span, static_cast<double>(objects)));
    row.push_back(PaperKeypointsCell(span, static_cast<double>(objects)));
  }
  return table;
}

Table StatisticsTable(const std::vector<NamedSpan>& spans) {
  Table table;
  table.columns = {"engine", "stage", "n", "mean [ms]", "std", "median", "p90", "p99", "max"};
  for (const NamedSpan& span : spans) {
    const SpanStatistics& s = span.milliseconds;
    std::vector<Cell>& row = table.rows.emplace_back();
    row = {TextCell(span.contender), TextCell(span.stage), CountCell(static_cast<long>(s.n))};
    for (const double value : {s.mean, s.deviation, s.median, s.p90, s.p99, s.max})
      row.push_back(NumberCell(value, 3));
  }
  table.notes = {
      "std: sample standard deviation; p90, p99: percentiles over the n frames, linear between "
      "neighbours. Spans as above."};
  return table;
}

Table RatioTable(const std::vector<NamedRatio>& ratios, const std::string& ours, size_t objects) {
  Table table;
  table.columns = {"engine", "n", fmt::format("times {}", ours), "p10", "p90"};
  for (const NamedRatio& named : ratios) {
    const SpanStatistics& s = named.ratio;
    table.rows.push_back({TextCell(named.contender), CountCell(static_cast<long>(s.n)),
                          NumberCell(s.median, 2), NumberCell(s.p10, 2), NumberCell(s.p90, 2)});
  }
  const double n = static_cast<double>(objects);
  table.rows.push_back({TextCell("paper: keypoints over its lines"), NoCell(),
                        NumberCell(paper::KeypointsMs(n) / paper::LinesMs(n), 2), NoCell(), NoCell()});
  table.notes = {
      fmt::format("times {}: total of the engine over that of {} in the same frame and repetition, which "
                  "the machine's drift hits alike: median, 10th and 90th percentile.",
                  ours, ours)};
  return table;
}

BenchSection ComparisonSection(const BenchTask& task) {
  const BenchSettings& settings = task.settings;
  BenchSection section{.name = "comparison", .sequence = task.sequence.name};
  RaceEngines(task, section);
  std::vector<BenchRow> used;
  std::copy_if(section.rows.begin(), section.rows.end(), std::back_inserter(used), [&](const BenchRow& row) {
    return row.outcome.objects == static_cast<int>(settings.objects);
  });
  section.spans = CollectSpans(section.name, section.sequence, used, settings.engines);
  section.ratios = CollectRatios(section.name, section.sequence, used, settings.engines);
  section.tables = {StageTable(used, settings.engines, settings.objects), StatisticsTable(section.spans),
                    RatioTable(section.ratios, settings.engines.front(), settings.objects)};
  AddNotes(task, used, section.tables[0]);
  const std::string where = fmt::format("{}: frames of {} with {} objects", task.sequence.name,
                                        ImageSize(task.sequence.camera), settings.objects);
  section.tables[0].title = where + ", median of each stage";
  section.tables[1].title = where + ", all statistics";
  section.tables[2].title = where + ", ratios";
  return section;
}

}  // namespace armature
