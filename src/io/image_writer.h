// SPDX-License-Identifier: BSD-3-Clause
// Writing pictures.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace armature {

// Throws InputError when the name does not end in .png, .jpg or .jpeg.
void CheckPictureName(const std::filesystem::path& file);

// Writes an 8-bit BGR or grey picture in the format of the name's ending, aside and renamed, so that the file
// is complete or as it was; folders around it are created. Throws InputError as CheckPictureName or when the
// place cannot be written to.
void WritePicture(const std::filesystem::path& file, const cv::Mat& picture);

}  // namespace armature
