// SPDX-License-Identifier: BSD-3-Clause
// Distributions side by side, as a picture: a strip of points each, with a box from quartile to quartile and
// a line at the median.
#pragma once

#include <string>
#include <vector>

namespace armature {

struct Strips {
  struct Strip {
    std::string name;
    std::vector<double> values;  // positive; what is not is left out
  };

  std::string title, label;   // label: of the logarithmic axis
  std::vector<Strip> strips;  // from the top
};

// The text of an SVG file, 900 wide and as high as it has strips. Throws InputError as RunGnuplot,
// std::logic_error when there is no value to draw.
std::string DrawSvg(const Strips& strips);

}  // namespace armature
