// SPDX-License-Identifier: BSD-3-Clause
#include "io/stage_statistics.h"

#include <algorithm>
#include <cmath>

namespace armature {

std::optional<double> Quantile(std::vector<float> values, double fraction) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double position = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<size_t>(std::floor(position));
  const size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(static_cast<double>(values[below]), static_cast<double>(values[above]),
                   position - std::floor(position));
}

void StageStatistics::Add(const StageTimes& times) {
  const std::array<double, 6> values{times.load,         times.lines,   times.association,
                                     times.optimization, times.mapping, times.total()};
  for (size_t i = 0; i < values.size(); ++i) stages_[i].milliseconds.push_back(static_cast<float>(values[i]));
}

}  // namespace armature
