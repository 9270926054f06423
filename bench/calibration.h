// SPDX-License-Identifier: BSD-3-Clause
// How fast the machine is at this moment: the same arithmetic and memory traffic every time. Absolute times
// on one machine move by 20 % with what else it does; times divided by the calibration's move less.
#pragma once

#include <string>
#include <vector>

#include "bench/harness.h"

namespace armature {

inline constexpr const char* kCalibrationName = "calibration";

// One pass, about 5 ms: half of it products and factorisations of small matrices with transcendental
// functions, as association and resection have them, half sweeps over more memory than the second cache
// holds, as detection has them. Always the same sum, but for the last digits of other mathematical libraries.
class CalibrationLoop {
 public:
  CalibrationLoop();
  double Pass();

 private:
  std::vector<float> memory_;
};

// Takes part in a race beside what it calibrates.
Contender CalibrationContender();

}  // namespace armature
