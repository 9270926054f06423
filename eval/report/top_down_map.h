// SPDX-License-Identifier: BSD-3-Clause
// A sequence's true and estimated maps seen from above.
#pragma once

#include <optional>

#include "eval/report/report_data.h"
#include "eval/report/sequence_runs.h"

namespace armature {

// Along gravity to the page: both rows are horizontal unit vectors, x to the right and y up on the page, and
// x cross y is up. x is the world's x axis as far as that is horizontal.
Eigen::Matrix<double, 2, 3> PageFromWorld(const Eigen::Vector3d& up);

// First the map of the first run, next to it that of the next run without loop closure, else the first run's
// objects placed by odometry, then the others. None where no run has a map.
std::optional<TopDownMap> MakeTopDownMap(const SequenceRuns& sequence);

}  // namespace armature
