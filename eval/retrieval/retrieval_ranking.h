// SPDX-License-Identifier: BSD-3-Clause
// All instances of a category in the order in which a way of retrieval has them.
#pragma once

#include <optional>
#include <vector>

#include "retrieval/retrieve.h"

namespace armature {

class InstanceRanking {
 public:
  // `k` and `radius` of the options do not matter. Keeps references to model and instances.
  InstanceRanking(const CategoryModel& model, const CategoryInstances& instances,
                  const RetrievalOptions& options);

  // The indices of all instances, best first: the candidates that are re-ranked (where the options ask for it
  // and there are sightings), then the rest by distance of the shape.
  std::vector<int> Of(const ShapeQuery& query, const ObjectSightings* sightings) const;

 private:
  InstanceRetrieval candidates_;
};

// The place of an instance in the ranking, from 1; none: it is not in it.
std::optional<int> FindRank(int instance, const std::vector<int>& ranking);

}  // namespace armature
