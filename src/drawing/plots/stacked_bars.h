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
  std::vector<std::string> stages;
  std::vector<Bar> bars;  // from the top
};

// An SVG file on white, 900x560 or higher for many bars; the totals stand beside the bars. The axis is
// linear, for lengths on a logarithmic one could not be added. Where some bars are less than a tenth of the
// longest, a second panel below shows them enlarged, the long ones cut. Throws InputError as RunGnuplot,
// std::logic_error when a bar has another number of parts than there are stages, or every bar is empty.
void WriteSvg(const StackedBars& bars, const std::filesystem::path& svg);

}  // namespace armature
