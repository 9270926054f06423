// SPDX-License-Identifier: BSD-3-Clause
// Why no pose of a trajectory has a true one: what a user can do about the stamps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/timed_pose.h"

namespace armature {

// The seconds to be added to the estimate's stamps so that its motion is most like the true one: how fast the
// camera moves and turns is compared, which depends on no frame and, moving or turning alone, on no scale.
// None where neither moves, or where the motions are nowhere alike. Both by growing stamps.
std::optional<double> FindTimeOffset(const std::vector<TimedPose>& estimate,
                                     const std::vector<TimedPose>& truth);

// One line: from when to when both are, and what may be wrong: another unit, an offset. Neither is empty.
std::string ExplainUnmatched(const std::vector<TimedPose>& estimate, const std::vector<TimedPose>& truth,
                             double tolerance_seconds);

}  // namespace armature
