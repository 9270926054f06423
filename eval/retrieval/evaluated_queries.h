// SPDX-License-Identifier: BSD-3-Clause
// The ways of retrieval that are measured against each other, queries with what became of them, and sets of
// them to make rows of.
#pragma once

#include <string>
#include <vector>

#include "eval/retrieval/retrieval_evaluation.h"
#include "retrieval/retrieve.h"

namespace armature {

struct RetrievalVariant {
  std::string name;  // as shown
  RetrievalOptions options;
};

inline constexpr const char* kPlainVariant = "k-NN, whitened";
inline constexpr const char* kCovarianceVariant = "covariance";
inline constexpr const char* kDefaultVariant = "covariance, re-ranked (default)";

// For objects that were seen: the plain form, its space, size and modes, the covariance, re-ranking. The last
// is the default.
std::vector<RetrievalVariant> VariantsForSeen();

// For known shapes: k-NN alone.
std::vector<RetrievalVariant> VariantsForShapes();

// Whether a variant is another one than with all modes for a category of so many.
bool IsDistinct(const RetrievalVariant& variant, int modes);

struct EvaluatedVariant {
  RetrievalVariant variant;
  std::vector<RetrievalOutcome> outcomes;  // one a query
};

struct EvaluatedQueries {
  std::vector<RetrievalQuery> queries;
  std::vector<EvaluatedVariant> variants;
  std::vector<RetrievalBaselines> baselines{};  // one a query; empty: not asked for

  // Throws std::logic_error when the variant was not evaluated.
  const std::vector<RetrievalOutcome>& GetOutcomes(const std::string& variant) const;
};

// Positions of queries, rising.
using QuerySet = std::vector<size_t>;

// A query's field by which rows are made.
using QueryField = std::string RetrievalQuery::*;

QuerySet AllQueries(const EvaluatedQueries& evaluated);

// Those with this value.
QuerySet Where(const EvaluatedQueries& evaluated, const QuerySet& among, QueryField field,
               const std::string& value);

// In the order in which they are met.
std::vector<std::string> CollectValues(const EvaluatedQueries& evaluated, const QuerySet& among,
                                       QueryField field);

template <typename T>
std::vector<T> Chosen(const std::vector<T>& of_all, const QuerySet& chosen) {
  std::vector<T> some;
  for (const size_t i : chosen) some.push_back(of_all[i]);
  return some;
}

}  // namespace armature
