// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/plots/strips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/statistics.h"
#include "drawing/plots/gnuplot.h"

namespace armature {
namespace {

constexpr double kHalfBox = 0.3;      // of the distance between strips
constexpr double kHalfSpread = 0.25;  // of points, across the strip

std::vector<double> DrawnValues(const Strips::Strip& strip) {
  std::vector<double> values;
  std::copy_if(strip.values.begin(), strip.values.end(), std::back_inserter(values),
               [](double value) { return std::isfinite(value) && value > 0; });
  return values;
}

// Points one after the other go up the strip by the golden ratio, so that neighbours are apart.
double SpreadOf(size_t point) {
  constexpr double kGolden = 0.6180339887;
  double whole = 0;
  return kHalfSpread * (2 * std::modf(kGolden * static_cast<double>(point), &whole) - 1);
}

std::string StripBlocks(const std::vector<double>& values, size_t index) {
  const double y = -static_cast<double>(index);
  std::string points = fmt::format("$points{} << EOD\n", index);
  for (size_t i = 0; i < values.size(); ++i)
    points += fmt::format("{} {}\n", GnuplotNumber(values[i]), y + SpreadOf(i));
  const double low = *Quantile(values, 0.25), high = *Quantile(values, 0.75), median = Median(values);
  const std::string box = fmt::format("$box{} << EOD\n{} {} {} {} {} {}\nEOD\n", index, GnuplotNumber(low), y,
                                      GnuplotNumber(low), GnuplotNumber(high), y - kHalfBox, y + kHalfBox);
  const std::string middle = fmt::format("$median{0} << EOD\n{1} {2}\n{1} {3}\nEOD\n", index,
                                         GnuplotNumber(median), y - kHalfBox, y + kHalfBox);
  return points + "EOD\n" + box + middle;
}

std::string DrawStrip(size_t index) {
  const std::string colour = PlotColour(index);
  return fmt::format(
      "$box{0} using 1:2:3:4:5:6 with boxxyerror fs solid 0.25 noborder lc rgb '{1}' notitle, \\\n"
      "$points{0} using 1:2 with points pt 7 ps 0.35 lc rgb '{1}' notitle, \\\n"
      "$median{0} using 1:2 with lines lw 3 lc rgb '{1}' notitle",
      index, colour);
}

std::string StripsScript(const Strips& strips) {
  std::string blocks, tics, draw;
  double low = HUGE_VAL, high = 0;
  for (size_t i = 0; i < strips.strips.size(); ++i) {
    tics +=
        fmt::format("{}{} {}", i == 0 ? "" : ", ", GnuplotText(strips.strips[i].name), -static_cast<int>(i));
    const std::vector<double> values = DrawnValues(strips.strips[i]);
    if (values.empty()) continue;
    blocks += StripBlocks(values, i);
    draw += (draw.empty() ? "plot " : ", \\\n") + DrawStrip(i);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  if (draw.empty()) throw std::logic_error("strips: nothing to draw in " + strips.title);
  const auto count = static_cast<int>(strips.strips.size());
  return SvgHeader(std::max(200 + 70 * count, 300)) + blocks +
         fmt::format("set title {}\nset xlabel {}\nset logscale x\nset xrange [{}:{}]\n",
                     GnuplotText(strips.title), GnuplotText(strips.label), low / 1.15, high * 1.15) +
         fmt::format("set ytics ({}) scale 0\nset yrange [{}:0.6]\nset grid noytics\n", tics, 0.4 - count) +
         draw + "\n";
}

}  // namespace

std::string DrawSvg(const Strips& strips) { return RunGnuplot(StripsScript(strips)); }

}  // namespace armature
