// SPDX-License-Identifier: BSD-3-Clause
// Sums and what they are made of, as a picture: one horizontal bar for each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace armature {

struct StackedBars {
  struct Bar {
    std::string name;
    std::vector<double> parts;  // one a stage, not negative; 0: it has no such stage
  };

  std::string title;
  std::string unit = "ms";
  int digits = 1;                   // of the totals, after the point
  std::vector<std::string> stages;  // in the legend; an empty name is not there
  std::vector<Bar> bars;            // from the top
};

// An SVG file on white, 900x560 or higher for many bars; the totals stand beside the bars. The axis is
// linear, for lengths on a logarithmic one could not be added. Where some bars are less than a tenth of the
// longest, a second panel below shows them enlarged, the long ones cut. Throws InputError as RunGnuplot,
// std::logic_error when a bar has another number of parts than there are stages, or every bar is empty.
void WriteSvg(const StackedBars& bars, const std::filesystem::path& svg);

// The same as the text of such a file.
std::string DrawSvg(const StackedBars& bars);

}  // namespace armature
