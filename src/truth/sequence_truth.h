// SPDX-License-Identifier: BSD-3-Clause
// What is true of a sequence, as far as evaluation goes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "geometry/camera.h"
#include "truth/ground_truth.h"
#include "truth/true_edges.h"

namespace armature {

inline constexpr const char* kTrueEdgesFile = "edges_gt.csv";

struct SequenceTruth {
  std::string name;
  Camera camera;
  GroundTruth truth;
  std::optional<TrueEdges> edges;  // none: the sequence has no edges_gt.csv
};

// sequence.yaml and the ground truth of a sequence folder. Throws InputError, also when there are true edges
// of a category without specification.
SequenceTruth LoadSequenceTruth(const std::filesystem::path& folder, const std::vector<CategorySpec>& specs);

}  // namespace armature
