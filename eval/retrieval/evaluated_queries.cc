// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/evaluated_queries.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace armature {
namespace {

RetrievalOptions Plain(const FeatureOptions& features) {
  RetrievalOptions options;
  options.features = features;
  options.covariance = false;
  options.rerank = false;
  return options;
}

std::string FirstModes(int modes) { return modes == 1 ? "first mode" : fmt::format("first {} modes", modes); }

RetrievalVariant PlainWithModes(int modes) {
  return {fmt::format("{}, {}", kPlainVariant, FirstModes(modes)), Plain({.modes = modes})};
}

RetrievalVariant CovarianceWithModes(int modes) {
  RetrievalVariant variant{fmt::format("{}, {}", kCovarianceVariant, FirstModes(modes)),
                           Plain({.modes = modes})};
  variant.options.covariance = true;
  return variant;
}

}  // namespace

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

std::vector<RetrievalVariant> VariantsForSeen() {
  RetrievalOptions covariance = Plain({}), reranked = Plain({});
  covariance.covariance = true;
  reranked.rerank = true;
  return {{"k-NN, raw", Plain({.space = FeatureSpace::kRaw})},
          {kPlainVariant, Plain({})},
          {"k-NN, whitened, with size", Plain({.with_size = true})},
          PlainWithModes(1),
          PlainWithModes(3),
          PlainWithModes(5),
          {kCovarianceVariant, covariance},
          CovarianceWithModes(3),
          CovarianceWithModes(5),
          {"k-NN, whitened, re-ranked", reranked},
          {kDefaultVariant, RetrievalOptions()}};
}

std::vector<RetrievalVariant> VariantsForShapes() {
  return {{"k-NN, raw", Plain({.space = FeatureSpace::kRaw})},
          {kPlainVariant, Plain({})},
          PlainWithModes(1),
          PlainWithModes(3),
          PlainWithModes(5)};
}

bool IsDistinct(const RetrievalVariant& variant, int modes) { return variant.options.features.modes < modes; }

}  // namespace armature
