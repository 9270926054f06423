// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/scaling_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bench/bench_sequence.h"
#include "bench/lines_engine.h"
#include "bench/sections/calibrated_race.h"
#include "bench/sections/load_variants.h"
#include "bench/span_notes.h"
#include "bench/spans.h"

namespace armature {
namespace {

// A variant in the race, and what its frames gave to do.
struct Entrant {
  LoadVariant variant;
  LinesEngine engine;
  std::vector<double> hypotheses, segments;  // a frame with objects, means over its objects
};

Contender MakeContender(Entrant& entrant) {
  Contender contender = MakeContender(entrant.variant.name(), entrant.engine, *entrant.variant.sequence);
  contender.after = [&entrant](BenchRow& row) {
    row.outcome.estimates.clear();
    if (row.outcome.objects == 0) return;
    const ViewCounts counts = CountViews(entrant.engine.last(), entrant.variant.sequence->camera,
                                         entrant.engine.models(), entrant.engine.options());
    entrant.hypotheses.push_back(counts.hypotheses);
    entrant.segments.push_back(counts.segments);
  };
  return contender;
}

// What was varied, as a number.
std::optional<double> CountAmount(const Entrant& entrant) {
  if (entrant.variant.load == Load::kHypotheses) return ComputeMedian(entrant.hypotheses);
  if (entrant.variant.load == Load::kSegments) return ComputeMedian(entrant.segments);
  const Camera& camera = entrant.variant.sequence->camera;
  return 1e-6 * camera.width * camera.height;
}

const char* AmountLabel(Load load) {
  if (load == Load::kHypotheses) return "hypotheses an object";
  return load == Load::kSegments ? "segments an object" : "megapixels";
}

// What grows with the load: association an object, or the detection in the image.
BenchSeries MakeSeries(Load load, const std::vector<const Entrant*>& entrants,
                       const std::vector<BenchRow>& rows) {
  const bool is_size = load == Load::kImageSize;
  BenchSeries series{.contender = LoadName(load),
                     .x_label = AmountLabel(load),
                     .y_label = is_size ? "detection [ms]" : "association [ms an object]"};
  std::vector<FitPoint> medians;
  for (const Entrant* entrant : entrants) {
    const std::string name = entrant->variant.name();
    const auto amount = CountAmount(*entrant);
    const auto statistics = ComputeStatistics(is_size ? CollectDurations(rows, name, kBenchStageNames[0])
                                                      : DurationsAnObject(rows, name, kBenchStageNames[1]));
    if (!amount || !statistics) continue;
    series.points.push_back({*amount, *statistics});
    medians.push_back({*amount, statistics->median});
  }
  std::stable_sort(series.points.begin(), series.points.end(),
                   [](const auto& a, const auto& b) { return a.x < b.x; });
  series.fit = FitLine(medians);
  return series;
}

Table LoadTable(Load load, const std::vector<const Entrant*>& entrants, const std::vector<BenchRow>& rows) {
  const bool is_size = load == Load::kImageSize;
  Table table;
  table.columns = {"variant",
                   is_size ? "megapixels" : "hypotheses",
                   "segments",
                   "n",
                   "detection [ms]",
                   "association [ms an object]",
                   "optimization [ms an object]",
                   "total [ms]"};
  for (const Entrant* entrant : entrants) {
    const std::string name = entrant->variant.name();
    const auto amount = is_size ? CountAmount(*entrant) : ComputeMedian(entrant->hypotheses);
    table.rows.push_back({TextCell(entrant->variant.setting), NumberCell(amount, is_size ? 3 : 0),
                          NumberCell(ComputeMedian(entrant->segments), 0),
                          CountCell(static_cast<long>(CollectDurations(rows, name, kTotal).size())),
                          NumberCell(MedianDuration(rows, name, kBenchStageNames[0]), 3),
                          NumberCell(ComputeMedian(DurationsAnObject(rows, name, kBenchStageNames[1])), 3),
                          NumberCell(ComputeMedian(DurationsAnObject(rows, name, kBenchStageNames[2])), 3),
                          NumberCell(MedianDuration(rows, name, kTotal), 3)});
  }
  return table;
}

std::vector<std::string> Notes(const BenchTask& task, const BenchSection& section,
                               const BenchSeries& series) {
  std::vector<std::string> notes{ClockNote(task.settings)};
  notes.push_back(
      fmt::format("The first {} frames of the sequence, all variants of all three tables in turn. "
                  "Medians; an object: the frame's time over its objects.",
                  section.frames + section.warmed_up));
  notes.push_back(
      "hypotheses, segments: means over a frame's objects, median over the frames, counted after the clock "
      "has stopped; segments are those in an object's box that association looks at.");
  if (series.fit) {
    notes.push_back(fmt::format("{}: {:.3f} + {:.5f} for each of '{}' (Theil-Sen through the medians).",
                                series.y_label, series.fit->constant, series.fit->slope, series.x_label));
  }
  return notes;
}

void AddLoad(Load load, const BenchTask& task, const std::deque<Entrant>& all, BenchSection& section) {
  std::vector<const Entrant*> entrants;
  for (const Entrant& entrant : all) {
    if (entrant.variant.load == load) entrants.push_back(&entrant);
  }
  section.series.push_back(MakeSeries(load, entrants, section.rows));
  Table& table = section.tables.emplace_back(LoadTable(load, entrants, section.rows));
  table.title = fmt::format("{}: time against {}", task.sequence.name, LoadName(load));
  table.notes = Notes(task, section, section.series.back());
  if (load == Load::kImageSize)
    table.notes.push_back(
        fmt::format("Images of {} resized, camera and boxes with them.", ImageSize(task.sequence.camera)));
}

}  // namespace

BenchSection ScalingSection(const BenchTask& task) {
  BenchSection section{.name = "scaling", .sequence = task.sequence.name};
  const BenchSequence sequence = FirstFrames(task.sequence, kMostScalingFrames);
  std::deque<BenchSequence> resized;
  std::deque<Entrant> entrants;
  std::vector<Contender> contenders;
  std::vector<std::string> names;
  constexpr std::array kLoads{Load::kHypotheses, Load::kSegments, Load::kImageSize};
  for (const Load load : kLoads) {
    for (LoadVariant& variant : MakeVariants(load, sequence, task.parts, resized)) {
      LinesEngine engine(variant.options, variant.models);
      entrants.push_back({std::move(variant), std::move(engine), {}, {}});
      contenders.push_back(MakeContender(entrants.back()));
      names.push_back(contenders.back().name);
    }
  }
  RaceCalibrated(contenders, sequence.frames.size(), task.settings.harness, section);
  section.spans = CollectSpans(section.name, section.sequence, section.rows, names);
  for (const Load load : kLoads) AddLoad(load, task, entrants, section);
  return section;
}

}  // namespace armature
