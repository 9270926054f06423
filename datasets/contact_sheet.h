// SPDX-License-Identifier: BSD-3-Clause
// A few pictures of each sequence side by side, to see at a glance what was generated.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

namespace armature {

struct ContactSheetOptions {
  int columns = 5;
  int rows = 2;        // of one sequence
  int width_px = 240;  // of a picture
  int margin_px = 4;
};

// Pictures evenly over each sequence folder's rgb.txt, one sequence below the other; 8-bit BGR. Throws
// InputError when a list or an image cannot be read.
cv::Mat3b ContactSheet(const std::vector<std::filesystem::path>& sequences,
                       const ContactSheetOptions& options = {});

}  // namespace armature
