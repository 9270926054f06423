// SPDX-License-Identifier: BSD-3-Clause
// A view of one object such as a detector and a line detector give, made by a fixed seed: the input of the
// micro-benchmarks of association and resection.
#pragma once

#include "association/object_view.h"
#include "pipeline/object_estimator.h"

namespace armature {

inline constexpr size_t kMicroSegments = 60;  // about what an object's box holds

// The category's mean object stands upright in the middle of an 856x480 image, seen from above and half from
// the side. Each visible edge is found as two fragments with noisy ends; the other segments are clutter
// inside the box.
struct MicroView {
  Camera camera{856, 480, 580, 580, 427.5, 239.5, {}};
  CategoryModel model;
  std::vector<Wireframe> dictionary;  // of the model
  PoseAndShape truth;
  ObjectView view;  // points to camera and model

  MicroView(const CategoryModel& category, size_t segments);
  MicroView(const MicroView&) = delete;
  MicroView& operator=(const MicroView&) = delete;

  // Its edges, without clipping to the box.
  ProjectedWireframe Project(const PoseAndShape& at) const;
  // A little beside the truth, as a good hypothesis is.
  PoseAndShape NearTruth() const;
};

}  // namespace armature
