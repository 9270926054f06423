// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/plots/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "drawing/plots/gnuplot.h"

namespace armature {
namespace {

bool IsDrawn(double value, bool log) { return std::isfinite(value) && (!log || value > 0); }

bool IsDrawn(const Plot& plot, const PlotSeries& series, size_t i) {
  return IsDrawn(series.x[i], plot.log_x) && IsDrawn(series.y[i], plot.log_y);
}

// A little beyond the outermost points: gnuplot itself would go on to the next round number.
std::string XRange(const Plot& plot) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const PlotSeries& series : plot.series) {
    for (size_t i = 0; i < series.y.size(); ++i) {
      if (!IsDrawn(plot, series, i)) continue;
      low = std::min(low, series.x[i]);
      high = std::max(high, series.x[i]);
    }
  }
  if (low > high) throw std::logic_error("plot: nothing to draw in " + plot.title);
  if (plot.log_x) return fmt::format("set logscale x\nset xrange [{}:{}]\n", low / 1.15, high * 1.15);
  const double margin = high > low ? 0.04 * (high - low) : 1;
  return fmt::format("set xrange [{}:{}]\n", low - margin, high + margin);
}

void CheckColumns(const Plot& plot) {
  for (const PlotSeries& s : plot.series) {
    const size_t bars = s.low.size();
    if (s.x.size() != s.y.size() || bars != s.high.size() || (bars != 0 && bars != s.y.size()))
      throw std::logic_error("plot: columns of different lengths in series " + s.name);
  }
}

std::string DataBlock(const Plot& plot, size_t index) {
  const PlotSeries& s = plot.series[index];
  std::string block = fmt::format("$data{} << EOD\n", index);
  for (size_t i = 0; i < s.y.size(); ++i) {
    if (!IsDrawn(plot, s, i)) continue;
    block += fmt::format("{} {}", GnuplotNumber(s.x[i]), GnuplotNumber(s.y[i]));
    if (!s.low.empty()) block += fmt::format(" {} {}", GnuplotNumber(s.low[i]), GnuplotNumber(s.high[i]));
    block += "\n";
  }
  return block + "EOD\n";
}

std::string FormatStyle(const PlotSeries& series, size_t colour) {
  const std::string line = fmt::format("lc rgb '{}' lw 2", PlotColour(colour));
  const std::string points = fmt::format("pt {} ps 0.7", 5 + 2 * (colour % 5));
  switch (series.style) {
    case PlotSeries::Style::kLine:
      return fmt::format("with linespoints {} {}", line, points);
    case PlotSeries::Style::kPoints:
      return fmt::format("with points {} {}", line, points);
    case PlotSeries::Style::kFitted:
      return fmt::format("with lines {} dt 2", line);
  }
  return "";
}

// What one series adds to the plot command.
std::string DrawSeries(const PlotSeries& series, size_t index) {
  const size_t colour = series.colour.value_or(index);
  std::string draw;
  if (!series.low.empty()) {
    draw =
        fmt::format("$data{} using 1:3:(0):($4-$3) with vectors nohead lc rgb '{}' lw 1 notitle, \\\n", index,
                    PlotColour(colour));  // gnuplot's own error bars stop short of the point
  }
  const std::string title =
      series.name.empty() ? "notitle" : fmt::format("title {}", GnuplotText(series.name));
  return draw + fmt::format("$data{} using 1:2 {} {}", index, FormatStyle(series, colour), title);
}

std::string Script(const Plot& plot) {
  CheckColumns(plot);
  std::string script = SvgHeader() + XRange(plot) + (plot.log_y ? "set logscale y\n" : "set yrange [0:]\n");
  script += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", GnuplotText(plot.title),
                        GnuplotText(plot.x_label), GnuplotText(plot.y_label));
  std::string draw;
  for (size_t i = 0; i < plot.series.size(); ++i) {
    if (plot.series[i].y.empty()) continue;
    script += DataBlock(plot, i);
    draw += fmt::format("{}{}", draw.empty() ? "plot " : ", \\\n", DrawSeries(plot.series[i], i));
  }
  return script + draw + "\n";
}

}  // namespace

void WriteSvg(const Plot& plot, const std::filesystem::path& svg) { RunGnuplot(Script(plot), svg); }

std::string DrawSvg(const Plot& plot) { return RunGnuplot(Script(plot)); }

}  // namespace armature
