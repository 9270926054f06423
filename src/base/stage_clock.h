// SPDX-License-Identifier: BSD-3-Clause
// Adds the wall time between construction and destruction to a stage's milliseconds.
#pragma once

#include <chrono>

namespace armature {

class StageClock {
 public:
  explicit StageClock(double& milliseconds) : milliseconds_(milliseconds), start_(Clock::now()) {}
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;
  ~StageClock() { milliseconds_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& milliseconds_;
  Clock::time_point start_;
};

}  // namespace armature
