// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/plots/stacked_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "base/number_format.h"
#include "drawing/plots/gnuplot.h"

namespace armature {
namespace {

constexpr double kHalfBar = 0.36;    // of the distance between bars
constexpr double kSmallShare = 0.1;  // of the longest bar: smaller ones are enlarged

double Total(const StackedBars::Bar& bar) { return std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0); }

double LongestBelow(const StackedBars& bars, double limit) {
  double longest = 0;
  for (const StackedBars::Bar& bar : bars.bars) {
    if (Total(bar) < limit) longest = std::max(longest, Total(bar));
  }
  return longest;
}

void CheckBars(const StackedBars& bars) {
  double sum = 0;
  for (const StackedBars::Bar& bar : bars.bars) {
    if (bar.parts.size() != bars.stages.size())
      throw std::logic_error("stacked bars: not as many parts as stages in bar " + bar.name);
    sum += Total(bar);
  }
  if (!(sum > 0)) throw std::logic_error("stacked bars: nothing to draw in " + bars.title);
}

// Rows for boxxyerror: middle and low, high of x and y of each part; the first bar is at y 0, the next at -1.
std::string StageBlock(const StackedBars& bars, size_t stage) {
  std::string block = fmt::format("$stage{} << EOD\n", stage);
  for (size_t i = 0; i < bars.bars.size(); ++i) {
    const std::vector<double>& parts = bars.bars[i].parts;
    const double low =
        std::accumulate(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(stage), 0.0);
    const double high = low + parts[stage], y = -static_cast<double>(i);
    block += fmt::format("{} {} {} {} {} {}\n", GnuplotNumber(low), y, GnuplotNumber(low),
                         GnuplotNumber(high), y - kHalfBar, y + kHalfBar);
  }
  return block + "EOD\n";
}

std::string BarNames(const StackedBars& bars) {
  std::string tics, labels;
  for (size_t i = 0; i < bars.bars.size(); ++i) {
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", GnuplotText(bars.bars[i].name), -static_cast<int>(i));
    labels += fmt::format("set label {} at graph 1.01, first {}\n",
                          GnuplotText(Fixed(Total(bars.bars[i]), bars.digits) + " " + bars.unit),
                          -static_cast<int>(i));
  }
  return "set ytics (" + tics + ") scale 0\n" + labels;
}

// One panel with the axis up to `limit`.
std::string Panel(const StackedBars& bars, const std::string& title, double limit, bool legend) {
  std::string panel = "set title " + GnuplotText(title) + "\n" + (legend ? "" : "unset key\n") +
                      fmt::format("set xrange [0:{}]\n", limit);
  for (size_t stage = 0; stage < bars.stages.size(); ++stage) {
    panel += fmt::format(
        "{} $stage{} using 1:2:3:4:5:6 with boxxyerror fs solid 1 noborder lc rgb '{}' title {}",
        stage == 0 ? "plot" : ", \\\n", stage, PlotColour(stage), GnuplotText(bars.stages[stage]));
  }
  return panel + "\n";
}

// Of two panels: names of more than four bars would run into each other otherwise.
int ComputeHeightOfTwo(size_t count) { return 560 + 60 * std::max(0, static_cast<int>(count) - 4); }

std::optional<double> EnlargedLimit(const StackedBars& bars, double longest) {
  const double small = LongestBelow(bars, kSmallShare * longest);
  return small > 0 ? std::optional(1.25 * small) : std::nullopt;
}

std::string Script(const StackedBars& bars) {
  CheckBars(bars);
  const double longest = LongestBelow(bars, 1e300);
  const std::optional<double> enlarged = EnlargedLimit(bars, longest);
  std::string script = SvgHeader(enlarged ? ComputeHeightOfTwo(bars.bars.size()) : 560);
  for (size_t stage = 0; stage < bars.stages.size(); ++stage) script += StageBlock(bars, stage);
  script += BarNames(bars);
  script += fmt::format("set yrange [{}:0.6]\nset grid noytics\nset rmargin 12\n",
                        0.4 - static_cast<double>(bars.bars.size()));
  script += "set xlabel " + GnuplotText(bars.unit) + "\n";
  if (enlarged) script += "set multiplot layout 2,1\n";
  script += Panel(bars, bars.title, 1.02 * longest, true);
  if (enlarged) {
    script +=
        Panel(bars, fmt::format("the same up to {} {}", Fixed(*enlarged, 1), bars.unit), *enlarged, false);
    script += "unset multiplot\n";
  }
  return script;
}

}  // namespace

void WriteSvg(const StackedBars& bars, const std::filesystem::path& svg) { RunGnuplot(Script(bars), svg); }

std::string DrawSvg(const StackedBars& bars) { return RunGnuplot(Script(bars)); }

}  // namespace armature
