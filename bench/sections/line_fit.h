// SPDX-License-Identifier: BSD-3-Clause
// A straight line through points of which a few may be far off (Theil-Sen).
#pragma once

#include <optional>
#include <vector>

namespace armature {

struct FitPoint {
  double x = 0, y = 0;
};

struct LineFit {
  double constant = 0;  // y at x = 0
  double slope = 0;     // y a unit of x

  double At(double x) const { return constant + slope * x; }
};

// The slope is the median of the slopes between all pairs of points of different x, the constant the median
// of what then remains: up to 29 % of the points may be anything (P. K. Sen, 1968). None for fewer than two
// different x.
std::optional<LineFit> FitLine(const std::vector<FitPoint>& points);

// The x at which both lines have the same y; none for parallel ones.
std::optional<double> Crossing(const LineFit& a, const LineFit& b);

}  // namespace armature
