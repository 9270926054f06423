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
  for (BenchRow& row : RunInterleaved(contenders, inputs, options)) {
    if (row.contender == kCalibrationName)
      section.calibration_ms.push_back(row.wall_ms);
    else
      section.rows.push_back(std::move(row));
  }
}

std::vector<size_t> SparseInputs(const std::function<bool(size_t input)>& is_used, size_t inputs,
                                 size_t warm_up, size_t count) {
  std::vector<size_t> used;
  for (size_t input = warm_up; input < inputs; ++input) {
    if (is_used(input)) used.push_back(input);
  }
  std::vector<size_t> sparse;
  for (size_t input = warm_up - std::min(warm_up, kSparseWarmUp); input < warm_up; ++input)
    sparse.push_back(input);
  const size_t step = std::max<size_t>(1, used.size() / std::max<size_t>(1, count));
  for (size_t i = 0; i < used.size(); i += step) sparse.push_back(used[i]);
  return sparse;
}

std::function<bool(size_t input)> PickOne(std::vector<size_t> inputs) {
  return [inputs = std::move(inputs)](size_t input) {
    return std::binary_search(inputs.begin(), inputs.end(), input);
  };
}

}  // namespace armature
