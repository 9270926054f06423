// SPDX-License-Identifier: BSD-3-Clause
#include "bench/sections/calibrated_race.h"

#include <algorithm>

#include "bench/guard/calibration.h"

namespace armature {

void RaceCalibrated(std::vector<Contender> contenders, size_t inputs, const HarnessOptions& options,
                    BenchSection& section) {
  contenders.push_back(CalibrationContender());
  section.warmed_up = options.warm_up;
  section.frames = inputs - std::min(inputs, options.warm_up);
  for (BenchRow& row : Race(contenders, inputs, options)) {
    if (row.contender == kCalibrationName)
      section.calibration_ms.push_back(row.wall_ms);
    else
      section.rows.push_back(std::move(row));
  }
}

}  // namespace armature
