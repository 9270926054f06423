// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/section_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/paper_figures.h"
#include "bench/spans.h"
#include "drawing/plots/plot.h"
#include "drawing/plots/stacked_bars.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr size_t kFitSamples = 40;  // a straight line is a curve on a logarithmic axis

// The bar of a contender, made when its first span comes.
StackedBars::Bar& FindBar(const std::string& name, StackedBars& bars) {
  const auto found = std::find_if(bars.bars.begin(), bars.bars.end(),
                                  [&](const StackedBars::Bar& bar) { return bar.name == name; });
  if (found != bars.bars.end()) return *found;
  return bars.bars.emplace_back(StackedBars::Bar{name, std::vector<double>(bars.stages.size())});
}

void DrawComparison(const BenchSection& section, size_t objects, const fs::path& folder) {
  StackedBars bars;
  bars.title = fmt::format("{}: median of each stage, frames with {} objects", section.sequence, objects);
  bars.stages.assign(kBenchStageNames.begin(), kBenchStageNames.end());
  bars.stages.push_back("paper: not split");  // its association and optimization; long names need many rows
  for (const NamedSpan& span : section.spans) {
    const auto stage = std::find(bars.stages.begin(), bars.stages.end(), span.stage);
    if (stage == bars.stages.end()) continue;
    FindBar(span.contender, bars).parts[static_cast<size_t>(stage - bars.stages.begin())] =
        span.milliseconds.median;
  }
  const double n = static_cast<double>(objects);
  bars.bars.push_back({"paper: lines", {paper::kLineDetectionMs, 0, 0, 0, n * paper::kLinesPerObjectMs}});
  bars.bars.push_back({"paper: keypoints", {paper::KeypointsMs(n), 0, 0, 0, 0}});
  WriteSvg(bars, folder / fmt::format("comparison-{}.svg", section.sequence));
}

PlotSeries Curve(const std::string& name, double from, double to, size_t colour,
                 const std::function<double(double)>& y) {
  PlotSeries curve{.name = name, .style = PlotSeries::Style::kFitted, .colour = colour};
  for (size_t i = 0; i < kFitSamples; ++i) {
    curve.x.push_back(from + (to - from) * static_cast<double>(i) / (kFitSamples - 1));
    curve.y.push_back(y(curve.x.back()));
  }
  return curve;
}

// Points with error bars, and the fitted line in the same colour.
void AddSeries(const BenchSeries& series, size_t colour, Plot& plot) {
  if (series.points.empty()) return;
  PlotSeries points{.name = series.contender, .style = PlotSeries::Style::kPoints, .colour = colour};
  for (const auto& [x, ms] : series.points) {
    points.x.push_back(x);
    points.y.push_back(ms.median);
    points.low.push_back(ms.p10);
    points.high.push_back(ms.p90);
  }
  const double from = points.x.front(), to = points.x.back();
  plot.series.push_back(std::move(points));
  if (series.fit)
    plot.series.push_back(Curve("", from, to, colour, [&](double x) { return series.fit->At(x); }));
}

// The first one is ours; on a logarithmic axis 8 ms and 855 ms can both be read.
void DrawObjects(const BenchSection& section, const fs::path& folder) {
  if (section.series.empty() || section.series.front().points.empty()) return;
  const BenchSeries& first = section.series.front();
  Plot plot{.title = section.sequence + ": medians with p10..p90, and lines through them",
            .x_label = first.x_label,
            .y_label = first.y_label,
            .log_y = true,
            .series = {}};
  size_t colour = 0;
  for (const BenchSeries& series : section.series) AddSeries(series, colour++, plot);
  const double from = first.points.front().x, to = first.points.back().x;
  plot.series.push_back(Curve("paper: lines", from, to, colour, paper::LinesMs));
  plot.series.push_back(Curve("paper: keypoints", from, to, colour + 1, paper::KeypointsMs));
  WriteSvg(plot, folder / fmt::format("objects-{}.svg", section.sequence));
}

void DrawScaling(const BenchSection& section, const fs::path& folder) {
  for (const BenchSeries& series : section.series) {
    if (series.points.empty()) continue;
    Plot plot{.title = fmt::format("{}: time against {}, medians with p10..p90", section.sequence,
                                   series.contender),
              .x_label = series.x_label,
              .y_label = series.y_label,
              .series = {}};
    AddSeries(series, 0, plot);
    plot.series.front().name = "";
    std::string load = series.contender;
    std::replace(load.begin(), load.end(), ' ', '-');
    WriteSvg(plot, folder / fmt::format("scaling-{}-{}.svg", load, section.sequence));
  }
}

void DrawRetrieval(const BenchSection& section, const fs::path& folder) {
  if (section.series.empty()) return;
  const BenchSeries& first = section.series.front();
  Plot plot{.title = "Retrieval: medians against the size of the library (recall@5 of the largest)",
            .x_label = first.x_label,
            .y_label = first.y_label,
            .log_x = true,
            .log_y = true,
            .series = {}};
  for (const BenchSeries& series : section.series) {
    PlotSeries& curve = plot.series.emplace_back(PlotSeries{.name = series.contender + series.remark});
    for (const auto& [x, ms] : series.points) {
      curve.x.push_back(x);
      curve.y.push_back(ms.median);
    }
  }
  WriteSvg(plot, folder / "retrieval.svg");
}

}  // namespace

bool IsDrawnTable(const std::string& table) {
  return table == "comparison" || table == "objects" || table == "scaling" || table == "retrieval";
}

void WriteSectionPlots(const BenchSection& section, size_t objects, const fs::path& folder) {
  if (section.name == "comparison") DrawComparison(section, objects, folder);
  if (section.name == "objects") DrawObjects(section, folder);
  if (section.name == "scaling") DrawScaling(section, folder);
  if (section.name == "retrieval") DrawRetrieval(section, folder);
}

}  // namespace armature
