// SPDX-License-Identifier: BSD-3-Clause
// The times of each stage, frame by frame.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pipeline/frame_result.h"

namespace armature {

// Keeps a number a stage and frame.
class StageStatistics {
 public:
  struct Stage {
    std::string name;
    std::vector<double> milliseconds;  // a value a frame
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
