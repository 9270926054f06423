// SPDX-License-Identifier: BSD-3-Clause
// How fast the machine is at this moment: the same arithmetic and memory traffic every time. Absolute times
// on one machine move by 20 % with what else it does; times divided by the calibration's move less.
#pragma once

#include <string>
#include <vector>

#include "bench/harness.h"

namespace armature {

inline constexpr const char* kCalibrationName = "calibration";  // a contender's
inline constexpr const char* kCalibrationStage = "pass";

// One pass, one to two milliseconds: products and factorisations of small matrices with transcendental
// functions, as association and resection have them, then sweeps over more memory than the second cache
// holds, as detection has them. It is so short that the system seldom takes the processor away within one:
// its median is the machine's speed, and its p90 shows that the machine was busy. Always the same sum, but
// for the last digits of other mathematical libraries.
class CalibrationLoop {
 public:
  CalibrationLoop();
  double Pass();

 private:
  std::vector<float> memory_;
};

// Takes part in a race beside what it calibrates. Each timed pass follows one that is not timed: what the
// others leave in the caches would make a quarter of its time.
Contender CalibrationContender();

}  // namespace armature
