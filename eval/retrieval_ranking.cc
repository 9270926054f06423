// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval_ranking.h"

#include <algorithm>

namespace armature {
namespace {

RetrievalOptions AllByShape(RetrievalOptions options, int instances) {
  options.k = std::max(instances, 1);
  options.radius = 0;
  options.rerank = false;
  return options;
}

RetrievalOptions AllCandidates(RetrievalOptions options) {
  options.k = options.candidates;
  options.radius = 0;
  return options;
}

}  // namespace

InstanceRanking::InstanceRanking(const CategoryModel& model, const CategoryInstances& instances,
                                 const RetrievalOptions& options)
    : by_shape_(model, instances, AllByShape(options, instances.size()),
                BuildIndex(model, instances, options)) {
  if (options.rerank)
    reranked_.emplace(model, instances, AllCandidates(options), BuildIndex(model, instances, options));
}

std::vector<int> InstanceRanking::Of(const ShapeQuery& query, const ObjectSightings* sightings) const {
  std::vector<int> ranking;
  std::vector<bool> is_ranked(static_cast<size_t>(by_shape_.instances().size()));
  const auto add = [&](const std::vector<RetrievedInstance>& retrieved) {
    for (const RetrievedInstance& r : retrieved) {
      if (is_ranked[static_cast<size_t>(r.instance)]) continue;
      is_ranked[static_cast<size_t>(r.instance)] = true;
      ranking.push_back(r.instance);
    }
  };
  if (reranked_ && sightings) add(reranked_->Retrieve(query, sightings));
  add(by_shape_.Retrieve(query, nullptr));
  return ranking;
}

std::optional<int> RankOf(int instance, const std::vector<int>& ranking) {
  const auto found = std::find(ranking.begin(), ranking.end(), instance);
  if (found == ranking.end()) return std::nullopt;
  return static_cast<int>(found - ranking.begin()) + 1;
}

}  // namespace armature
