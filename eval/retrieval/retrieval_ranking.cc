// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_ranking.h"

#include <algorithm>

namespace armature {
namespace {

RetrievalOptions AllCandidates(RetrievalOptions options) {
  options.k = options.candidates;
  options.radius = 0;
  return options;
}

}  // namespace

InstanceRanking::InstanceRanking(const CategoryModel& model, const CategoryInstances& instances,
                                 const RetrievalOptions& options)
    : candidates_(model, instances, AllCandidates(options), BuildIndex(model, instances, options)) {}

std::vector<int> InstanceRanking::Of(const ShapeQuery& query, const ObjectSightings* sightings) const {
  const int all = candidates_.instances().size();
  std::vector<int> ranking;
  std::vector<bool> is_ranked(static_cast<size_t>(all));
  const auto add = [&](int instance) {
    if (is_ranked[static_cast<size_t>(instance)]) return;
    is_ranked[static_cast<size_t>(instance)] = true;
    ranking.push_back(instance);
  };
  for (const RetrievedInstance& candidate : candidates_.Retrieve(query, sightings)) add(candidate.instance);
  for (const Neighbour& neighbour : candidates_.Nearest(query, std::max(all, 1))) add(neighbour.instance);
  return ranking;
}

std::optional<int> FindRank(int instance, const std::vector<int>& ranking) {
  const auto found = std::find(ranking.begin(), ranking.end(), instance);
  if (found == ranking.end()) return std::nullopt;
  return static_cast<int>(found - ranking.begin()) + 1;
}

}  // namespace armature
