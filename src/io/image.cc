// SPDX-License-Identifier: BSD-3-Clause
#include "io/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string_view>
#include <vector>

#include "base/console.h"
#include "base/errors.h"
#include "base/text.h"
#include "io/atomic_write.h"
#include "io/exif_orientation.h"

namespace armature {
namespace {

constexpr int kJpegQuality = 95;
constexpr size_t kMostImageBytes = size_t{1} << 30;  // OpenCV counts them with an int

// A complete JPEG has an end-of-image mark behind its last start of scan; the decoder fills what is missing
// with grey.
bool IsTruncatedJpeg(std::string_view bytes) {
  if (!bytes.starts_with("\xFF\xD8")) return false;
  const size_t last_scan = bytes.rfind("\xFF\xDA");
  return last_scan == std::string_view::npos || bytes.find("\xFF\xD9", last_scan) == std::string_view::npos;
}

// What cameras and tools write. OpenCV tries its decoders on anything else, and that of medical images ends
// the program.
bool IsKnownFormat(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::string_view kStarts[] = {
      "\xFF\xD8"sv,           "\x89PNG\r\n\x1A\n"sv, "BM"sv,         "II*\0"sv, "MM\0*"sv, "v/1\x01"sv,
      "\0\0\0\x0CjP  \r\n"sv, "\xFF\x4F\xFF\x51"sv,  "#?RADIANCE"sv, "#?RGBE"sv};
  const bool is_webp =
      bytes.starts_with("RIFF"sv) && bytes.substr(std::min<size_t>(8, bytes.size())).starts_with("WEBP"sv);
  const bool is_pnm = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7';
  return is_webp || is_pnm ||
         std::any_of(std::begin(kStarts), std::end(kStarts),
                     [&](std::string_view start) { return bytes.starts_with(start); });
}

// Pixels as the camera made them, which is what intrinsics and boxes are of: never turned by an orientation.
cv::Mat Decode(std::string& bytes, int depth) {
  if (bytes.empty() || bytes.size() > kMostImageBytes || !IsKnownFormat(bytes) || IsTruncatedJpeg(bytes))
    return {};
  try {
    return cv::imdecode(cv::Mat(1, static_cast<int>(bytes.size()), CV_8UC1, bytes.data()),
                        cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION | depth);
  } catch (const cv::Exception&) {
    return {};
  }
}

// Of whole numbers: as many bits as the largest value needs, an even number of them as sensors have.
int CountBits(const cv::Mat& image) {
  double largest = 0;
  cv::minMaxLoc(image.reshape(1), nullptr, &largest);
  int bits = 8;
  while (largest >= (1 << bits) && bits < 16) bits += 2;
  return bits;
}

// Eight bits of an image that has more: of sensors with 10, 12 or 14 the highest that are used, of real
// numbers 0..1, or 0..the largest.
cv::Mat ToEightBits(const std::filesystem::path& file, const cv::Mat& image, std::string& bytes) {
  cv::Mat result;
  if (image.depth() == CV_16U) {
    const int bits = CountBits(image);
    if (bits == 16) return Decode(bytes, 0);
    NoteOnce("bits of images",
             fmt::format("{}: 16-bit image that holds {} bits: stretched to all of its range, "
                         "as others like it are",
                         file.string(), bits));
    image.convertTo(result, CV_8U, std::pow(2.0, 8 - bits), bits == 8 ? 0 : -0.5 + std::pow(2.0, 7 - bits));
    return result;
  }
  double smallest = 0, largest = 0;
  cv::minMaxLoc(image.reshape(1), &smallest, &largest);
  if (!std::isfinite(largest) || !std::isfinite(smallest)) return {};
  if (largest > 1) {
    NoteOnce("range of images",
             fmt::format("{}: image of real numbers to {:g}: brought to 0..1 by the largest, "
                         "as others like it are",
                         file.string(), largest));
  }
  image.convertTo(result, CV_8U, 255 / std::max(1.0, largest));
  return result;
}

void TellOrientation(const std::filesystem::path& file, int orientation) {
  if (orientation == 1) return;
  NoteOnce("orientation of images",
           fmt::format("{}: EXIF orientation {} is ignored here and in others like it: pixels are as stored, "
                       "which intrinsics and boxes are to be of",
                       file.string(), orientation));
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
  cv::Mat image = Decode(bytes, cv::IMREAD_ANYDEPTH);
  if (!image.empty() && image.depth() != CV_8U) image = ToEightBits(file, image, bytes);
  if (image.empty()) {
    return {std::nullopt,
            fmt::format("{}: is not a complete image that can be decoded; replace the file", file.string())};
  }
  ImageResult result{std::move(image), "", FindExifOrientation(bytes)};
  TellOrientation(file, result.orientation);
  return result;
}

ImageResult ReadImage(const std::filesystem::path& file, const Camera& camera) {
  ImageResult result = ReadImage(file);
  if (!result.image) return result;
  if (result.image->cols == camera.width && result.image->rows == camera.height) return result;
  const bool is_turned =
      result.orientation >= 5 && result.image->cols == camera.height && result.image->rows == camera.width;
  const std::string remedy =
      is_turned
          ? fmt::format("its EXIF orientation {} is ignored, so give the intrinsics of the pixels as stored",
                        result.orientation)
          : "correct sequence.yaml or replace the image";
  return {std::nullopt,
          fmt::format("{}: is {} x {} pixels where the camera has {} x {}; {}", file.string(),
                      result.image->cols, result.image->rows, camera.width, camera.height, remedy)};
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
