// SPDX-License-Identifier: BSD-3-Clause
// All options of retrieval: every field's default is here, its key, help and range in RetrievalOptionTable.
#pragma once

#include <vector>

#include "base/option_entry.h"
#include "retrieval/instance_fit.h"
#include "retrieval/instance_index.h"
#include "retrieval/shape_distance.h"

namespace armature {

struct RetrievalOptions {
  int k = 5;          // neighbours; the paper's number
  double radius = 0;  // only those at most this far; 0: however far
  FeatureOptions features;
  IndexMethod index;
  bool covariance = true;        // weigh with the covariance of the estimated coefficients
  double evidence_sigma = 0.15;  // standard deviations: what that covariance does not know of
  bool rerank = true;            // order the nearest by how well their own edges explain the images
  int candidates = 200;          // how many are re-ranked, 1-2 ms each
  int views = 24;                // images at most, spread over those in which the object was seen
  InstanceFitOptions fit;
};

// One row an option, "retrieval.k" and so on; the rows point into `retrieval`.
std::vector<OptionEntry> RetrievalOptionTable(RetrievalOptions& retrieval);

}  // namespace armature
