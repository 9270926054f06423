// SPDX-License-Identifier: BSD-3-Clause
// Which object of a map is which true object.
#pragma once

#include <utility>
#include <vector>

#include "io/placed_objects.h"
#include "io/run_results.h"
#include "truth/ground_truth.h"

namespace armature {

// Positions in the map's and in the truth's list of objects; each object is in one pair at most, both of a
// pair are of the same category. By growing position in the truth.
using ObjectPairs = std::vector<std::pair<size_t, size_t>>;

// By where they are: one-to-one with the most pairs, of those the least sum of the centres' distances, none
// further apart than the gate (metres). `map` in the frame of the truth.
ObjectPairs MatchByDistance(const std::vector<PlacedObject>& map, const std::vector<TrueObject>& truth,
                            double gate_m);

// By what they were made from, however far they are: each map object is the true object that most of its
// observations are of (detections_gt.csv); of several map objects of one true object the one with the most of
// them is it, the others are none. Equally many: the first in the list. Without pairs where the run's
// observations name no objects.
ObjectPairs MatchByDetections(const std::vector<PlacedObject>& map, const RunResults& run,
                              const GroundTruth& truth);

}  // namespace armature
