// SPDX-License-Identifier: BSD-3-Clause
// Random numbers for evaluations, the same on every platform: the standard's distributions are not.
#pragma once

#include <cstdint>
#include <random>

namespace armature {

class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [0, 1).
  double Uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

  // Close to normal with mean 0 and deviation 1: the sum of twelve uniform numbers, within six deviations.
  double Normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += Uniform();
    return sum;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace armature
