// SPDX-License-Identifier: BSD-3-Clause
#include "io/image.h"

#include <fmt/format.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "io/atomic_write.h"

namespace armature {
namespace {

constexpr int kJpegQuality = 95;

// A complete JPEG has an end-of-image mark behind its last start of scan; the decoder fills what is missing
// with grey.
bool IsTruncatedJpeg(std::string_view bytes) {
  if (!bytes.starts_with("\xFF\xD8")) return false;
  const size_t last_scan = bytes.rfind("\xFF\xDA");
  return last_scan == std::string_view::npos || bytes.find("\xFF\xD9", last_scan) == std::string_view::npos;
}

cv::Mat Decode(std::string& bytes) {
  if (bytes.empty() || IsTruncatedJpeg(bytes)) return {};
  try {
    return cv::imdecode(cv::Mat(1, static_cast<int>(bytes.size()), CV_8UC1, bytes.data()), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};
  }
}

// As the name's ending says.
std::string Encoded(const std::filesystem::path& name, const cv::Mat& picture) {
  CheckPictureName(name);
  std::vector<unsigned char> bytes;
  cv::imencode(name.extension().string(), picture, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return {bytes.begin(), bytes.end()};
}

}  // namespace

ImageResult ReadImage(const std::filesystem::path& file) {
  std::string bytes;
  try {
    bytes = ReadTextFile(file);
  } catch (const InputError& error) {
    return {std::nullopt, error.what()};
  }
  cv::Mat image = Decode(bytes);
  if (image.empty()) {
    return {std::nullopt,
            fmt::format("{}: is not a complete image that can be decoded; replace the file", file.string())};
  }
  return {std::move(image), ""};
}

ImageResult ReadImage(const std::filesystem::path& file, const Camera& camera) {
  ImageResult result = ReadImage(file);
  if (!result.image) return result;
  if (result.image->cols == camera.width && result.image->rows == camera.height) return result;
  return {std::nullopt,
          fmt::format("{}: is {} x {} pixels where the camera has {} x {}; correct sequence.yaml or "
                      "replace the image",
                      file.string(), result.image->cols, result.image->rows, camera.width, camera.height)};
}

cv::Mat Undistorted(const cv::Mat& image, const Camera& camera) {
  if (!camera.IsDistorted()) return image;
  const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  cv::Mat result;
  cv::undistort(image, result, K, camera.distortion);
  return result;
}

void CheckPictureName(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") return;
  throw InputError(fmt::format("{}: is no name of a picture; let it end in .png or .jpg", file.string()));
}

void WritePicture(const std::filesystem::path& file, const cv::Mat& picture) {
  AtomicWrite(file, Encoded(file, picture));
}

void WritePictureInside(const std::filesystem::path& file, const cv::Mat& picture) {
  WriteFile(file, Encoded(file, picture));
}

}  // namespace armature
