// SPDX-License-Identifier: BSD-3-Clause
#include "io/stage_statistics.h"

namespace armature {

void StageStatistics::Add(const StageTimes& times) {
  const std::array<double, 6> values{times.load,         times.lines,   times.association,
                                     times.optimization, times.mapping, times.total()};
  for (size_t i = 0; i < values.size(); ++i) stages_[i].milliseconds.push_back(values[i]);
}

}  // namespace armature
