// SPDX-License-Identifier: BSD-3-Clause
// The pipeline with more or less to do: what is varied to see how times grow.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "bench/engine.h"
#include "bench/engines.h"

namespace armature {

enum class Load { kHypotheses, kSegments, kImageSize };

struct LoadVariant {
  Load load = Load::kHypotheses;
  std::string setting;  // "azimuths every 15 deg within 30 and 2 shapes"
  Options options;
  std::vector<CategoryModel> models;
  const BenchSequence* sequence = nullptr;

  std::string name() const;  // "segments: at most 40"
};

// "hypotheses", "segments", "image size"
std::string LoadName(Load load);

// All variants of a load, from the least to the most. `resized` takes the sequences that they need besides
// the given one; both have to outlive them.
std::vector<LoadVariant> MakeVariants(Load load, const BenchSequence& sequence, const EngineParts& parts,
                                      std::deque<BenchSequence>& resized);

}  // namespace armature
