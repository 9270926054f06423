// SPDX-License-Identifier: BSD-3-Clause
// What of an image belongs to a detection.
#pragma once

#include <vector>

#include "association/object_view.h"
#include "pipeline/options.h"

namespace armature {

// The detection with its box undistorted and the segments near it. The view keeps references to camera and
// model.
ObjectView MakeView(const Detection& detection, const std::vector<Segment>& segments,
                    const Eigen::Vector3d& up_camera, const Camera& camera, const CategoryModel& model,
                    const Options& options);

}  // namespace armature
