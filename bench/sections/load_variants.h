// SPDX-License-Identifier: BSD-3-Clause
// The pipeline with more or less to do: what is varied to see how times grow, and how much work that gives
// association.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "bench/engine.h"
#include "bench/engines.h"
#include "category/category_model.h"
#include "geometry/camera.h"
#include "pipeline/frame_result.h"
#include "pipeline/options.h"

namespace armature {

// Means over the objects of a frame.
struct ViewCounts {
  double hypotheses = 0;  // made, before any is left out; what a track remembers would add one
  double segments = 0;    // in the box, at most association.max_segments
};

// Makes the views and hypotheses of the frame's objects again, to count them; boxes are taken as they are,
// also those of a distorting lens. Requires an object.
ViewCounts CountViews(const FrameResult& frame, const Camera& camera,
                      const std::vector<CategoryModel>& models, const Options& options);

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
