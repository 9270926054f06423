// SPDX-License-Identifier: BSD-3-Clause
// From an object of the map to the CAD models it may be (paper 4.2).
#pragma once

#include <optional>
#include <vector>

#include "retrieval/instance_library.h"
#include "retrieval/retrieval_options.h"

namespace armature {

struct RetrievedInstance {
  int instance = 0;                // of the library's category
  double distance = 0;             // of the shape; see Features and Likeliest for its unit
  std::optional<InstanceFit> fit;  // where it was re-ranked
};

// The index over the instances' features that the options ask for. `model` is the one that the instances'
// coefficients are of.
InstanceIndex BuildIndex(const CategoryModel& model, const CategoryInstances& instances,
                         const RetrievalOptions& options);

// One category's instances with what finds them.
class InstanceRetrieval {
 public:
  // `index` as of BuildIndex. Keeps references to model and instances.
  InstanceRetrieval(const CategoryModel& model, const CategoryInstances& instances,
                    const RetrievalOptions& options, InstanceIndex index);

  // Best first, at most k. By covariance where that is asked for and the query has evidence, re-ranked where
  // that is asked for and there are sightings.
  std::vector<RetrievedInstance> Retrieve(const ShapeQuery& query, const ObjectSightings* sightings) const;

  // By the shape alone: no radius, no re-ranking.
  std::vector<Neighbour> Nearest(const ShapeQuery& query, int k) const;

  const CategoryInstances& instances() const { return instances_; }

 private:
  void Rerank(const ObjectSightings& sightings, std::vector<RetrievedInstance>& retrieved) const;

  const CategoryModel& model_;
  const CategoryInstances& instances_;
  RetrievalOptions options_;
  InstanceIndex index_;
};

}  // namespace armature
