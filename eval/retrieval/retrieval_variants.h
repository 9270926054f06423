// SPDX-License-Identifier: BSD-3-Clause
// The ways of retrieval that are measured against each other.
#pragma once

#include <string>
#include <vector>

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

}  // namespace armature
