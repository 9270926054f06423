// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/evaluated_queries.h"

#include <algorithm>
#include <stdexcept>

namespace armature {

const std::vector<RetrievalOutcome>& EvaluatedQueries::GetOutcomes(const std::string& variant) const {
  for (const EvaluatedVariant& evaluated : variants) {
    if (evaluated.variant.name == variant) return evaluated.outcomes;
  }
  throw std::logic_error("not evaluated: " + variant);
}

QuerySet AllQueries(const EvaluatedQueries& evaluated) {
  QuerySet all(evaluated.queries.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

QuerySet Where(const EvaluatedQueries& evaluated, const QuerySet& among, QueryField field,
               const std::string& value) {
  QuerySet chosen;
  for (const size_t i : among) {
    if (evaluated.queries[i].*field == value) chosen.push_back(i);
  }
  return chosen;
}

std::vector<std::string> CollectValues(const EvaluatedQueries& evaluated, const QuerySet& among,
                                       QueryField field) {
  std::vector<std::string> values;
  for (const size_t i : among) {
    const std::string& value = evaluated.queries[i].*field;
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

}  // namespace armature
