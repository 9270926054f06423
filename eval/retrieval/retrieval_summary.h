// SPDX-License-Identifier: BSD-3-Clause
// Numbers over several queries.
#pragma once

#include <optional>
#include <vector>

#include "eval/retrieval/retrieval_evaluation.h"

namespace armature {

struct RetrievalSummary {
  int queries = 0;
  // Of those whose true model is in the library.
  int in_library = 0;
  int top_1 = 0, top_5 = 0;  // how many ranks are 1, are at most 5
  std::optional<double> mean_reciprocal_rank, median_rank;
  // Of those whose surfaces are known, all of the same ones: what was retrieved and what the true shape
  // finds.
  int compared = 0;
  std::optional<double> chamfer, best_of_five, by_truth;  // means, metres
  std::optional<double> ratio;                            // chamfer / by_truth
  std::optional<double> f_score, f_score_by_truth;        // means, 0..1
};

RetrievalSummary Summarise(const std::vector<RetrievalOutcome>& outcomes);

struct BaselineSummary {
  std::optional<double> random, mean_shape;  // means of those that are known, metres
};

BaselineSummary Summarise(const std::vector<RetrievalBaselines>& baselines);

}  // namespace armature
