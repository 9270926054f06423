// SPDX-License-Identifier: BSD-3-Clause
// Something that is the case for stretches of time.
#pragma once

#include <optional>

#include "geometry/random.h"

namespace armature {

// A chain of two states in continuous time, looked at now and then: forward only.
class Stretches {
 public:
  // Whether it is the case at the time [s], which must not be before the last one. `share` of all time, in
  // stretches of `seconds` in the mean; 0 seconds: independent of what was before. Draws one number.
  bool IsOn(double share, double seconds, double time, Random& random);

  // Whether the last IsOn began a stretch.
  bool has_begun() const { return has_begun_; }

 private:
  std::optional<double> last_time_;
  bool is_on_ = false, has_begun_ = false;
};

}  // namespace armature
