// SPDX-License-Identifier: BSD-3-Clause
// From an object of the map to the CAD models it may be (paper 4.2).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "retrieval/instance_fit.h"
#include "retrieval/instance_index.h"
#include "retrieval/instance_library.h"
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

struct RetrievedInstance {
  int instance = 0;                // of the library's category
  double distance = 0;             // of the shape; see Features and Likeliest for its unit
  std::optional<InstanceFit> fit;  // where it was re-ranked
};

// One category's instances with what finds them.
class InstanceRetrieval {
 public:
  // `model` is the one that the instances' coefficients are of. Builds the index, or takes a finished one of
  // the same features. Keeps references to model and instances.
  InstanceRetrieval(const CategoryModel& model, const CategoryInstances& instances,
                    const RetrievalOptions& options);

  // Best first, at most k. With covariance where the query has evidence, re-ranked where there are sightings.
  std::vector<RetrievedInstance> Retrieve(const ShapeQuery& query, const ObjectSightings* sightings) const;

  const CategoryInstances& instances() const { return instances_; }

 private:
  std::vector<Neighbour> Nearest(const ShapeQuery& query, int k) const;
  void Rerank(const ObjectSightings& sightings, std::vector<RetrievedInstance>& retrieved) const;

  const CategoryModel& model_;
  const CategoryInstances& instances_;
  RetrievalOptions options_;
  InstanceIndex index_;
};

}  // namespace armature
