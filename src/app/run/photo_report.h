// SPDX-License-Identifier: BSD-3-Clause
// What `armature photo` prints.
#pragma once

#include <string>
#include <vector>

#include "category/category_model.h"
#include "pipeline/frame_result.h"

namespace armature {

// A row an object, in the order of the boxes; then where the picture is. `models`: of all categories that
// occur.
std::string PhotoReportText(const FrameResult& frame, const std::vector<CategoryModel>& models,
                            const std::string& picture);

// The same as an object, with T_camera_object, shape coefficients and the estimated up direction.
std::string PhotoReportJson(const FrameResult& frame, const std::vector<CategoryModel>& models,
                            const std::string& picture);

}  // namespace armature
