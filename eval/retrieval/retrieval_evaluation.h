// SPDX-License-Identifier: BSD-3-Clause
// How good the retrieved CAD models are: the true model's rank, and how far others' surfaces are from its.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/retrieval/retrieval_queries.h"
#include "eval/retrieval/retrieval_surfaces.h"
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

// One query by one way of retrieval. "Others": the instances of its category without the true one, and
// without those that have no surface.
struct RetrievalOutcome {
  std::optional<int> rank;                      // of the true model, from 1; none: it is not in the library
  int first_other = -1;                         // the best of the others; -1: there are none
  std::optional<SurfaceDistance> retrieved;     // first_other's surface from the true one
  std::optional<SurfaceDistance> best_of_five;  // the nearest surface of the first five others
  std::optional<SurfaceDistance> by_truth;      // of the other that is nearest by the true shape
};

// What needs no estimate: Chamfer distances, metres. None: the surfaces are not there.
struct RetrievalBaselines {
  std::optional<double> random;      // mean of 50 others, or of all where they are fewer
  std::optional<double> mean_shape;  // of the other that is nearest to the category's mean shape
};

// Queries about one library.
class RetrievalEvaluation {
 public:
  // Finds each query's true model in `true_models` (the library itself, or a collection that has what the
  // library is not to know) and reads its surface, `points` on each. Keeps references to all but
  // `true_models`. Throws InputError: a malformed surface, a category without model.
  RetrievalEvaluation(const std::vector<RetrievalQuery>& queries, const std::vector<CategoryModel>& models,
                      const InstanceLibrary& library, const InstanceLibrary& true_models, int points);
  ~RetrievalEvaluation();

  // One a query, in their order; of a category that the library has no instances of nothing is known.
  std::vector<RetrievalOutcome> Evaluate(const RetrievalOptions& options);
  std::vector<RetrievalBaselines> Baselines();

 private:
  struct Asked;

  void Add(const RetrievalQuery& query, const CategoryModel& model, const InstanceLibrary& true_models);
  RetrievalOutcome Judge(Asked& asked, const std::vector<int>& ranking, const std::vector<int>& by_truth);

  const InstanceLibrary& library_;
  int points_;
  LibrarySurfaces surfaces_;
  std::map<std::string, std::vector<bool>> has_surface_;  // by category, one an instance
  std::vector<Asked> asked_;
};

}  // namespace armature
