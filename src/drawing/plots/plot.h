// SPDX-License-Identifier: BSD-3-Clause
// Numbers against numbers, as a picture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature {

struct PlotSeries {
  enum class Style {
    kLine,    // points and lines between them
    kPoints,  // points alone
    kFitted,  // a dashed line without points
  };

  std::string name;  // in the legend; empty: not there
  Style style = Style::kLine;
  std::vector<double> x{}, y{};       // as many; what is not finite is left out
  std::vector<double> low{}, high{};  // ends of error bars, as many as y, or none
  std::optional<size_t> colour{};     // see PlotColour; none: the position among the series
};

struct Plot {
  std::string title;
  std::string x_label, y_label;
  bool log_x = false, log_y = false;  // then what is not positive is left out; a linear y axis begins at 0
  std::vector<PlotSeries> series;
};

// An SVG file, 900x560 on white. Throws InputError as RunGnuplot, std::logic_error when columns of a series
// have different lengths or there is nothing to draw.
void WriteSvg(const Plot& plot, const std::filesystem::path& svg);

// The same as the text of such a file.
std::string DrawSvg(const Plot& plot);

}  // namespace armature
