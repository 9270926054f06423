// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/stretches.h"

#include <cmath>

namespace armature {

bool Stretches::IsOn(double share, double seconds, double time, Random& random) {
  // Left at the rate 1 / seconds, and begun at the rate that keeps the share, what it is now decays with the
  // sum of both rates: that is 1 / (seconds (1 - share)).
  const double memory = seconds * (1 - share);
  const double kept = last_time_ && memory > 0 ? std::exp(-(time - *last_time_) / memory) : 0;
  const bool was_on = is_on_ && last_time_;
  is_on_ = random.Uniform(0, 1) < share + kept * ((was_on ? 1.0 : 0.0) - share);
  has_begun_ = is_on_ && !was_on;
  last_time_ = time;
  return is_on_;
}

}  // namespace armature
