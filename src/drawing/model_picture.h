// SPDX-License-Identifier: BSD-3-Clause
// A single CAD model as a picture, lit as those of a map are.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace armature {

struct ModelPictureOptions {
  int width = 220, height = 180;  // pixels
  int samples = 6;                // rays a pixel
};

// Models side by side: all on white, from the same side and to the same scale, the largest as large as fits.
// Each picture is 8-bit BGR. `meshes` in centred object frames (y up), metres, each with a triangle.
// `T_camera_object`: from where they are seen; the pictures' middle is where the object's origin is. The same
// bytes for any number of threads.
std::vector<cv::Mat> DrawModels(const std::vector<TriangleMesh>& meshes,
                                const Eigen::Isometry3d& T_camera_object,
                                const ModelPictureOptions& options = {});

}  // namespace armature
