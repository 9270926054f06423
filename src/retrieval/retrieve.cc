// SPDX-License-Identifier: BSD-3-Clause
#include "retrieval/retrieve.h"

#include <algorithm>
#include <utility>

namespace armature {

InstanceIndex BuildIndex(const CategoryModel& model, const CategoryInstances& instances,
                         const RetrievalOptions& options) {
  return {Features(instances, model.standard_deviations, options.features), options.index};
}

InstanceRetrieval::InstanceRetrieval(const CategoryModel& model, const CategoryInstances& instances,
                                     const RetrievalOptions& options, InstanceIndex index)
    : model_(model), instances_(instances), options_(options), index_(std::move(index)) {}

std::vector<Neighbour> InstanceRetrieval::Nearest(const ShapeQuery& query, int k) const {
  if (options_.covariance && query.evidence)
    return Likeliest(instances_, *query.evidence, options_.evidence_sigma, options_.features.modes, k);
  return index_.Nearest(ComputeFeatures(query, model_.standard_deviations, options_.features), k);
}

void InstanceRetrieval::Rerank(const ObjectSightings& sightings,
                               std::vector<RetrievedInstance>& retrieved) const {
  std::vector<std::pair<double, size_t>> order;
  for (size_t i = 0; i < retrieved.size(); ++i) {
    const Wireframe wireframe = instances_.MakeWireframe(retrieved[i].instance);
    retrieved[i].fit = FitInstance(sightings, model_.spec, wireframe,
                                   instances_.size_sigmas(retrieved[i].instance), options_.fit);
    order.emplace_back(retrieved[i].fit->cost, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<RetrievedInstance> sorted;
  sorted.reserve(retrieved.size());
  for (const auto& [cost, i] : order) sorted.push_back(retrieved[i]);
  retrieved = std::move(sorted);
}

std::vector<RetrievedInstance> InstanceRetrieval::Retrieve(const ShapeQuery& query,
                                                           const ObjectSightings* sightings) const {
  const bool rerank = options_.rerank && sightings && !sightings->frames.empty();
  std::vector<RetrievedInstance> retrieved;
  for (const auto& [instance, distance] :
       Nearest(query, rerank ? std::max(options_.candidates, options_.k) : options_.k)) {
    if (options_.radius > 0 && distance > options_.radius) break;
    retrieved.push_back({instance, distance, std::nullopt});
  }
  if (rerank) Rerank(*sightings, retrieved);
  if (retrieved.size() > static_cast<size_t>(options_.k)) retrieved.resize(static_cast<size_t>(options_.k));
  return retrieved;
}

}  // namespace armature
