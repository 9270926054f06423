// SPDX-License-Identifier: BSD-3-Clause
// An error that stays for a while.
#pragma once

#include <optional>

#include "geometry/random.h"

namespace armature {

// An autoregressive process of first order with unit variance, looked at now and then: forward only.
class LastingError {
 public:
  // Its value at the time [s], which must not be before the last one; the correlation falls to 1/e within
  // `seconds` (0: at once). Draws one number of Random::Normal.
  double At(double time, double seconds, Random& random);

 private:
  std::optional<double> last_time_;
  double value_ = 0;
};

}  // namespace armature
