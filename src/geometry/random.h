// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same on every platform: the standard's distributions are not.
#pragma once

#include <cstdint>
#include <random>

namespace armature {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [low, high).
  double Uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }

  // Close to normal: the sum of twelve uniform numbers, within six standard deviations.
  double Normal(double mean, double deviation) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += Uniform(0, 1);
    return mean + deviation * sum;
  }

 private:
  std::mt19937_64 engine_;
};

// The seed of a second stream that has nothing to do with the first; another for each `stream`.
inline std::uint64_t StreamSeed(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t mixed = seed + (stream + 1) * 0x9E3779B97F4A7C15;  // splitmix64 (Steele et al. 2014)
  mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
  mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
  return mixed ^ (mixed >> 31);
}

}  // namespace armature
