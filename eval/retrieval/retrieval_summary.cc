// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_summary.h"

#include "base/statistics.h"
#include "truth/observation_metrics.h"

namespace armature {
namespace {

class Average {
 public:
  void Add(double value) {
    sum_ += value;
    ++count_;
  }
  void Add(const std::optional<double>& value) {
    if (value) Add(*value);
  }
  std::optional<double> Value() const {
    return count_ > 0 ? std::optional<double>(sum_ / count_) : std::nullopt;
  }

 private:
  double sum_ = 0;
  int count_ = 0;
};

void SummariseRanks(const std::vector<RetrievalOutcome>& outcomes, RetrievalSummary& summary) {
  std::vector<double> ranks;
  Average reciprocal;
  for (const RetrievalOutcome& outcome : outcomes) {
    if (!outcome.rank) continue;
    ranks.push_back(*outcome.rank);
    reciprocal.Add(1.0 / *outcome.rank);
    summary.top_1 += *outcome.rank == 1;
    summary.top_5 += *outcome.rank <= 5;
  }
  summary.in_library = static_cast<int>(ranks.size());
  summary.mean_reciprocal_rank = reciprocal.Value();
  if (!ranks.empty()) summary.median_rank = Median(std::move(ranks));
}

void SummariseSurfaces(const std::vector<RetrievalOutcome>& outcomes, RetrievalSummary& summary) {
  Average chamfer, best_of_five, by_truth, f_score, f_score_by_truth;
  for (const RetrievalOutcome& outcome : outcomes) {
    if (!outcome.retrieved || !outcome.best_of_five || !outcome.by_truth) continue;
    ++summary.compared;
    chamfer.Add(outcome.retrieved->chamfer);
    best_of_five.Add(outcome.best_of_five->chamfer);
    by_truth.Add(outcome.by_truth->chamfer);
    f_score.Add(outcome.retrieved->f_score);
    f_score_by_truth.Add(outcome.by_truth->f_score);
  }
  summary.chamfer = chamfer.Value();
  summary.best_of_five = best_of_five.Value();
  summary.by_truth = by_truth.Value();
  summary.f_score = f_score.Value();
  summary.f_score_by_truth = f_score_by_truth.Value();
  if (summary.by_truth && *summary.by_truth > 0) summary.ratio = *summary.chamfer / *summary.by_truth;
}

}  // namespace

RetrievalSummary Summarise(const std::vector<RetrievalOutcome>& outcomes) {
  RetrievalSummary summary;
  summary.queries = static_cast<int>(outcomes.size());
  SummariseRanks(outcomes, summary);
  SummariseSurfaces(outcomes, summary);
  return summary;
}

BaselineSummary Summarise(const std::vector<RetrievalBaselines>& baselines) {
  Average random, mean_shape;
  for (const RetrievalBaselines& one : baselines) {
    random.Add(one.random);
    mean_shape.Add(one.mean_shape);
  }
  return {random.Value(), mean_shape.Value()};
}

}  // namespace armature
