// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/lasting_error.h"

#include <cmath>

namespace armature {

double LastingError::At(double time, double seconds, Random& random) {
  const double kept = last_time_ && seconds > 0 ? std::exp(-(time - *last_time_) / seconds) : 0;
  value_ = kept * value_ + std::sqrt(1 - kept * kept) * random.Normal(0, 1);
  last_time_ = time;
  return value_;
}

}  // namespace armature
