// SPDX-License-Identifier: BSD-3-Clause
// Images read, pictures written.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "geometry/camera.h"

namespace armature {

// Throws InputError when the name does not end in .png, .jpg or .jpeg.
void CheckPictureName(const std::filesystem::path& file);

// Writes an 8-bit BGR or grey picture in the format of the name's ending, aside and renamed, so that the file
// is complete or as it was; folders around it are created. Throws InputError as CheckPictureName or when the
// place cannot be written to.
void WritePicture(const std::filesystem::path& file, const cv::Mat& picture);

// The same in an OutputFolder.
void WritePictureInside(const std::filesystem::path& file, const cv::Mat& picture);

struct ImageResult {
  std::optional<cv::Mat> image;  // 8-bit BGR
  std::string error;             // "file: what is wrong; remedy", one line, when there is no image
  int orientation = 1;           // the file's EXIF tag, which is not followed
};

// Reads the whole image, which has to be of the camera's size. No name: there is none, which the error says.
// A truncated JPEG counts as unreadable. Never throws for bad files: the caller decides whether one
// unreadable image is skipped or ends the run. Grey becomes colour, transparency is left out; a note says, of
// the first such file, that an EXIF orientation is not followed, that 16 bits hold fewer and are stretched,
// and to what real numbers are brought.
ImageResult ReadImage(const std::filesystem::path& file, const Camera& camera);

// The same for an image of any size.
ImageResult ReadImage(const std::filesystem::path& file);

// The image as a lens without distortion would have made it, of the same camera matrix; shares the pixels
// when there is no distortion.
cv::Mat Undistorted(const cv::Mat& image, const Camera& camera);

}  // namespace armature
