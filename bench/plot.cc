// SPDX-License-Identifier: BSD-3-Clause
#include "bench/plot.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "bench/gnuplot.h"

namespace armature {
namespace {

bool IsDrawn(double value, bool log) { return std::isfinite(value) && (!log || value > 0); }

size_t DrawnPoints(const Plot& plot) {
  size_t drawn = 0;
  for (const PlotSeries& series : plot.series) {
    for (size_t i = 0; i < series.y.size(); ++i)
      drawn += IsDrawn(series.x[i], plot.log_x) && IsDrawn(series.y[i], plot.log_y) ? 1 : 0;
  }
  return drawn;
}

void Check(const Plot& plot) {
  for (const PlotSeries& s : plot.series) {
    const size_t bars = s.low.size();
    if (s.x.size() != s.y.size() || bars != s.high.size() || (bars != 0 && bars != s.y.size()))
      throw std::logic_error("plot: columns of different lengths in series " + s.name);
  }
  if (DrawnPoints(plot) == 0) throw std::logic_error("plot: nothing to draw in " + plot.title);
}

std::string DataBlock(const Plot& plot, size_t index) {
  const PlotSeries& s = plot.series[index];
  std::string block = fmt::format("$data{} << EOD\n", index);
  for (size_t i = 0; i < s.y.size(); ++i) {
    if (!IsDrawn(s.x[i], plot.log_x) || !IsDrawn(s.y[i], plot.log_y)) continue;
    block += fmt::format("{} {}", GnuplotNumber(s.x[i]), GnuplotNumber(s.y[i]));
    if (!s.low.empty()) block += fmt::format(" {} {}", GnuplotNumber(s.low[i]), GnuplotNumber(s.high[i]));
    block += "\n";
  }
  return block + "EOD\n";
}

std::string StyleOf(const PlotSeries& series, size_t colour) {
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
    draw = fmt::format("$data{} using 1:2:3:4 with yerrorbars lc rgb '{}' lw 1 pt 0 notitle, \\\n", index,
                       PlotColour(colour));
  }
  const std::string title =
      series.name.empty() ? "notitle" : fmt::format("title {}", GnuplotText(series.name));
  return draw + fmt::format("$data{} using 1:2 {} {}", index, StyleOf(series, colour), title);
}

}  // namespace

void WriteSvg(const Plot& plot, const std::filesystem::path& svg) {
  Check(plot);
  std::string script = SvgHeader();
  std::string draw;
  for (size_t i = 0; i < plot.series.size(); ++i) {
    if (plot.series[i].y.empty()) continue;
    script += DataBlock(plot, i);
    draw += fmt::format("{}{}", draw.empty() ? "plot " : ", \\\n", DrawSeries(plot.series[i], i));
  }
  script += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nset key below\n",
                        GnuplotText(plot.title), GnuplotText(plot.x_label), GnuplotText(plot.y_label));
  script += plot.log_x ? "set logscale x\n" : "set offsets graph 0.03, graph 0.03, 0, 0\n";
  script += plot.log_y ? "set logscale y\n" : "set yrange [0:]\n";
  RunGnuplot(script + draw + "\n", svg);
}

}  // namespace armature
