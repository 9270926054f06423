// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/objects_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>

#include "base/paper_figures.h"
#include "bench/bench_sequence.h"
#include "bench/sections/calibrated_race.h"
#include "bench/span_notes.h"
#include "bench/spans.h"

namespace armature {
namespace {

constexpr std::array<size_t, 12> kCounts{1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 18, 20};
constexpr double kUsualCount = 3;  // of the paper's comparison

// All counts together are so many times the usual one: a baseline takes part in fewer frames.
constexpr size_t kFewerBaselineFrames = 4;
constexpr size_t kLeastBaselineFrames = 3;

std::string EntrantName(const std::string& engine, size_t count) {
  return fmt::format("{} with {} object{}", engine, count, count == 1 ? "" : "s");
}

size_t BaselineFrames(const BenchSettings& settings) {
  return std::max(settings.baseline_frames / kFewerBaselineFrames, kLeastBaselineFrames);
}

// Frames, engines and contenders of all counts; contenders refer to the others, which do not move.
struct Entrants {
  std::deque<FilledSequence> filled;     // one a count
  std::deque<BenchSequence> few_frames;  // one a baseline
  std::vector<std::unique_ptr<Engine>> engines;
  std::vector<Contender> contenders;
};

std::function<bool(size_t)> HasObjects(const BenchSequence& sequence) {
  return [&sequence](size_t input) { return !sequence.frames[input].input.detections.empty(); };
}

void AddContender(Contender contender, Entrants& entrants) {
  contender.after = [](BenchRow& row) { row.outcome.estimates.clear(); };
  entrants.contenders.push_back(std::move(contender));
}

// An engine a count, each with a memory of its own.
void AddRemembering(const BenchTask& task, const std::string& name, Entrants& entrants) {
  for (size_t i = 0; i < kCounts.size(); ++i) {
    const BenchSequence& sequence = entrants.filled[i].sequence;
    Engine& engine = *entrants.engines.emplace_back(MakeEngine(name, task.parts));
    Contender contender = MakeContender(EntrantName(name, kCounts[i]), engine, sequence);
    contender.wants = HasObjects(task.sequence);
    AddContender(std::move(contender), entrants);
  }
}

// One engine for all counts, as its network is large; it is given a few frames of each count, in one
// sequence, as what it prepares for a frame is large too.
void AddBaseline(const BenchTask& task, const std::string& name, Entrants& entrants) {
  const std::vector<size_t> inputs =
      SparseInputs(HasObjects(task.sequence), task.sequence.frames.size(), task.settings.harness.warm_up,
                   BaselineFrames(task.settings));
  const auto first_counted = std::lower_bound(inputs.begin(), inputs.end(), task.settings.harness.warm_up);
  BenchSequence& few = entrants.few_frames.emplace_back(FirstFrames(task.sequence, 0));
  Engine& engine = *entrants.engines.emplace_back(MakeEngine(name, task.parts));
  for (size_t i = 0; i < kCounts.size(); ++i) {
    std::map<size_t, size_t> frame_of_input;
    for (const size_t input : inputs) {
      frame_of_input[input] = few.frames.size();
      few.frames.push_back(entrants.filled[i].sequence.frames[input]);
    }
    Contender contender = MakeContender(EntrantName(name, kCounts[i]), engine, few);
    if (i > 0) contender.start = {};  // the first one starts it for all
    contender.run = [&engine, &few, frame_of_input](size_t input) {
      return engine.Process(few.frames[frame_of_input.at(input)]);
    };
    // The largest count warms up the network for all.
    const bool warms_up = i + 1 == kCounts.size();
    contender.wants = PickOne({warms_up ? inputs.begin() : first_counted, inputs.end()});
    AddContender(std::move(contender), entrants);
  }
}

Entrants MakeEntrants(const BenchTask& task) {
  Entrants entrants;
  for (const size_t count : kCounts) entrants.filled.push_back(WithObjects(task.sequence, count));
  for (const std::string& name : task.settings.engines)
    (IsLinesEngine(name) ? AddRemembering : AddBaseline)(task, name, entrants);
  return entrants;
}

BenchSeries MakeSeries(const std::string& engine, const std::vector<BenchRow>& rows) {
  BenchSeries series{.contender = engine, .x_label = "objects in the frame", .y_label = "total [ms]"};
  std::vector<FitPoint> medians;
  for (const size_t count : kCounts) {
    const auto statistics = ComputeStatistics(CollectDurations(rows, EntrantName(engine, count), kTotal));
    if (!statistics) continue;
    series.points.push_back({static_cast<double>(count), *statistics});
    medians.push_back({static_cast<double>(count), statistics->median});
  }
  series.fit = FitLine(medians);
  return series;
}

Table CountTable(const std::vector<BenchSeries>& series, const std::deque<FilledSequence>& filled) {
  Table table;
  table.columns = {"objects", "repeated [%]"};
  for (const BenchSeries& s : series) {
    table.columns.insert(table.columns.end(), {s.contender + " [ms]", "mean", "n"});
  }
  for (size_t i = 0; i < kCounts.size(); ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row = {CountCell(static_cast<long>(kCounts[i])), NumberCell(100 * filled[i].repeated_share, 1)};
    for (const BenchSeries& s : series) {
      const SpanStatistics& statistics = s.points.at(i).milliseconds;
      row.push_back(NumberCell(statistics.median, 3));
      row.push_back(NumberCell(statistics.mean, 3));
      row.push_back(CountCell(static_cast<long>(statistics.n)));
    }
  }
  return table;
}

void AddNotes(const BenchTask& task, std::vector<Table>& tables) {
  tables[0].notes = {
      ClockNote(task.settings),
      "Columns of an engine: median and mean total of a frame and how many frames; total: around "
      "the whole call, with what a baseline counts without waiting. The map is solved now and then: in the "
      "mean, hardly in the median.",
      "All numbers of objects are on the same frames, those with at least one detection, each with a memory "
      "of its own. Detections are the frame's own, largest first, then again in turn: repeated, the share "
      "of all that are."};
  for (std::string& note : EngineNotes(task.settings.engines, task.parts))
    tables[0].notes.push_back(std::move(note));
}

std::vector<Cell> FitRow(const std::string& name, const LineFit& fit, double ratio, const Cell& crossover) {
  return {TextCell(name), NumberCell(fit.constant, 3), NumberCell(fit.slope, 3), NumberCell(ratio, 2),
          crossover};
}

// Largest count over the usual one.
double Growth(const BenchSeries& series) {
  const auto usual = std::find_if(series.points.begin(), series.points.end(),
                                  [](const BenchSeries::Point& point) { return point.x == kUsualCount; });
  if (usual == series.points.end()) return std::nan("");
  return series.points.back().milliseconds.median / usual->milliseconds.median;
}

}  // namespace

std::string CrossoverText(const LineFit& ours, const LineFit& other) {
  const auto crossing = Crossing(ours, other);
  const bool below_at_one = ours.At(1) < other.At(1);
  if (!crossing || *crossing <= 1) {
    const bool below = crossing ? ours.slope < other.slope : below_at_one;
    return fmt::format("none: ours is {} from 1 object on", below ? "below" : "above");
  }
  return fmt::format("ours is {} from {:.1f} objects on", below_at_one ? "above" : "below", *crossing);
}

Table ObjectFitTable(const std::vector<BenchSeries>& series) {
  Table table;
  table.columns = {"engine", "constant [ms]", "an object [ms]", "20 objects over 3", "crossover with ours"};
  const BenchSeries& ours = series.front();
  for (const BenchSeries& s : series) {
    if (!s.fit || !ours.fit) continue;
    const bool is_ours = &s == &ours;
    table.rows.push_back(FitRow(s.contender, *s.fit, Growth(s),
                                is_ours ? NoCell() : TextCell(CrossoverText(*ours.fit, *s.fit))));
  }
  const LineFit lines{paper::kLineDetectionMs, paper::kLinesPerObjectMs};
  const LineFit keypoints{0, paper::kKeypointsPerObjectMs};
  table.rows.push_back(FitRow("paper: lines", lines, paper::LinesMs(20) / paper::LinesMs(3), NoCell()));
  table.rows.push_back(FitRow("paper: keypoints", keypoints, 20.0 / 3,
                              TextCell("with the paper's lines: " + CrossoverText(lines, keypoints))));
  table.notes = {
      "constant, an object: a line through the medians above (Theil-Sen: median of the slopes between all "
      "pairs, then of what remains).",
      fmt::format("crossover with ours: where that line meets the one of {}. paper: as printed, on its own "
                  "hardware.",
                  ours.contender)};
  return table;
}

BenchSection ObjectsSection(const BenchTask& task) {
  const BenchSettings& settings = task.settings;
  BenchSection section{.name = "objects", .sequence = task.sequence.name};
  const Entrants entrants = MakeEntrants(task);
  RaceCalibrated(entrants.contenders, task.sequence.frames.size(), settings.harness, section);
  std::vector<std::string> names;
  for (const Contender& contender : entrants.contenders) names.push_back(contender.name);
  section.spans = CollectSpans(section.name, section.sequence, section.rows, names);
  for (const std::string& engine : settings.engines)
    section.series.push_back(MakeSeries(engine, section.rows));
  section.tables = {CountTable(section.series, entrants.filled), ObjectFitTable(section.series)};
  AddNotes(task, section.tables);
  section.tables[0].title = fmt::format("{}: time against the number of objects", task.sequence.name);
  section.tables[1].title = fmt::format("{}: constant and part an object", task.sequence.name);
  return section;
}

}  // namespace armature
