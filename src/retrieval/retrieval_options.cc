// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/retrieval_options.h"

// A row's key is the path of its field; those that only studies turn are under "expert.".
#define OPTION(path, ...) Option(#path, &path, __VA_ARGS__)
#define EXPERT_OPTION(path, ...) Option("expert." #path, &path, __VA_ARGS__)

namespace armature {

std::vector<OptionEntry> RetrievalOptionTable(RetrievalOptions& retrieval) {
  return {
      OPTION(retrieval.k, "how many of the nearest instances are listed", 1, 1000000),
      OPTION(retrieval.radius,
             "farthest instance that is listed, in the distance's unit (standard deviations, or metres where "
             "space is raw); 0: however far",
             0),
      OPTION(retrieval.features.space, "distances of coefficients: in standard deviations, or raw, metres"),
      OPTION(retrieval.features.modes, "how many of the first coefficients are compared; 0: all", 0,
             kMaxModes),
      OPTION(retrieval.features.with_size, "compare the box's size as three more dimensions"),
      OPTION(retrieval.index.kind, "how nearest neighbours are found, by FLANN"),
      OPTION(retrieval.covariance, "weigh by the covariance of the estimated coefficients"),
      OPTION(retrieval.rerank, "order the nearest by how well their own edges explain the images"),
      OPTION(retrieval.candidates, "how many of the nearest are re-ranked", 1, 1000000),
      OPTION(retrieval.views, "most images that they are re-ranked by", 1, 100000),
      EXPERT_OPTION(retrieval.index.leaf_size, "kdtree_single: instances a leaf", 1, 1000),
      EXPERT_OPTION(retrieval.index.trees, "kdtree: how many trees", 1, 64),
      EXPERT_OPTION(retrieval.index.branching, "kmeans: branches of a node", 2, 1000),
      EXPERT_OPTION(retrieval.index.iterations, "kmeans: most iterations", 1, 1000),
      EXPERT_OPTION(retrieval.index.checks, "kdtree, kmeans: instances that a query looks at", 1, 1000000),
  };
}

}  // namespace armature

#undef OPTION
#undef EXPERT_OPTION
