// SPDX-License-Identifier: BSD-3-Clause
// Medians and percentiles of the stages' times.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/frame_result.h"

namespace armature {

// The value below which the fraction of the values lies, linear between neighbours (numpy's default); none
// for no value.
std::optional<double> Quantile(std::vector<float> values, double fraction);

// Keeps one float a stage and frame.
class StageStatistics {
 public:
  struct Stage {
    std::string name;
    std::vector<float> milliseconds;  // a value a frame
  };

  void Add(const StageTimes& times);
  // load, lines, association, optimization, mapping, total (without load)
  const std::array<Stage, 6>& stages() const { return stages_; }

 private:
  std::array<Stage, 6> stages_{{{"load", {}},
                                {"lines", {}},
                                {"association", {}},
                                {"optimization", {}},
                                {"mapping", {}},
                                {"total", {}}}};
};

}  // namespace armature
