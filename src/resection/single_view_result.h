// SPDX-License-Identifier: BSD-3-Clause
// What one image says about one object, after association and resection.
#pragma once

#include "resection/line_resection.h"
#include "resection/object_estimate.h"

namespace armature {

struct EstimatorTimes {        // milliseconds, wall clock
  double association_ms = 0;   // paper 3.3: hypotheses, costs, matches
  double optimization_ms = 0;  // paper 3.4
};

struct SingleViewResult {
  ObjectEstimate estimate;
  // The same matches without what earlier frames said (track prior, floor): what this image alone measures,
  // to learn from. Learning from the estimate would count it twice.
  Measurement measured;
  ImageEvidence evidence;  // the same again without up and shape statistics, about measured.estimate
  PoseAndShape initial;    // the winning hypothesis before resection
  EstimatorTimes times;
};

}  // namespace armature
