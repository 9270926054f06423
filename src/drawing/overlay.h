// SPDX-License-Identifier: BSD-3-Clause
// Pictures of what was found in a frame.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "category/category_model.h"
#include "geometry/camera.h"
#include "pipeline/frame_result.h"

namespace armature {

// The image, dimmed, and on it: all segments (grey), and for each detection its box (thin), its wireframe
// before the resection (thin, pale) and after it (solid, where there is an estimate), the matched segments in
// a colour of their edge, and a label `category azimuth distance status`. `image`: 8-bit BGR or grey,
// undistorted as the frame's segments are. `models`: of all categories that occur; others are drawn as boxes
// alone.
cv::Mat DrawOverlay(const cv::Mat& image, const FrameResult& frame, const std::vector<CategoryModel>& models,
                    const Camera& camera);

// The visible parts of the wireframe's edges in the image: cut at the near plane and at the image's border.
std::vector<Segment> ProjectedEdges(const Wireframe& wireframe, const Eigen::Isometry3d& T_camera_object,
                                    const Camera& camera);

}  // namespace armature
