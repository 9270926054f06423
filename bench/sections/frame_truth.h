// SPDX-License-Identifier: BSD-3-Clause
// What is true of the detections of each frame, to judge what engines find. For evaluation only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/engine.h"
#include "category/category_model.h"
#include "truth/cad_library.h"
#include "truth/visible_edges.h"

namespace armature {

struct TrueDetection {
  std::string category;
  int symmetry_order = 1;
  Eigen::Isometry3d T_camera_object = Eigen::Isometry3d::Identity();  // metres
  std::optional<std::vector<VisibleEdge>> edges;                      // none: the object's own are not known
};

// One a detection; none: it is of no true object.
using FrameTruth = std::vector<std::optional<TrueDetection>>;

// One a frame of the sequence that was read from the folder; empty when the folder has no ground truth of
// objects. Throws InputError for a malformed one.
std::vector<FrameTruth> LoadFrameTruth(const std::filesystem::path& folder, const BenchSequence& sequence,
                                       const std::vector<CategoryModel>& models, const CadLibrary& cad);

}  // namespace armature
