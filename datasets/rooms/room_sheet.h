// SPDX-License-Identifier: BSD-3-Clause
// Pictures of many rooms on one sheet.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "datasets/scene/scene.h"

namespace armature {

// The room from above: chairs blue, tables brown, laptops red, distractors grey, the camera's path with where
// it looks. 8-bit BGR.
cv::Mat3b RoomPlan(const Scene& scene, const std::string& label);

struct RoomPictures {
  std::filesystem::path folder;  // a sequence
  cv::Mat3b plan;
};

// Two rooms a row: two pictures of each and its plan. Throws InputError when a picture cannot be read.
cv::Mat3b RoomSheet(const std::vector<RoomPictures>& rooms);

}  // namespace armature
