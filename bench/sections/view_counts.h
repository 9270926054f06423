// SPDX-License-Identifier: BSD-3-Clause
// How much work a frame gives association: hypotheses and segments of its objects.
#pragma once

#include <vector>

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

}  // namespace armature
