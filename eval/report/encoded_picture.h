// SPDX-License-Identifier: BSD-3-Clause
// Pictures as bytes of a file.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "eval/report/report_data.h"

namespace armature {

// 8-bit BGR as JPEG, made smaller to the width (pixels) where it is wider.
ReportPicture JpegPicture(const cv::Mat& picture, int most_width, const std::string& alt);

}  // namespace armature
