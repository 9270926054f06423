// SPDX-License-Identifier: BSD-3-Clause
#include "eval/retrieval/retrieval_variants.h"

#include <fmt/format.h>

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
