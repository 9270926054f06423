// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report/encoded_picture.h"

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

namespace armature {
namespace {

constexpr int kJpegQuality = 80;

}  // namespace

ReportPicture JpegPicture(const cv::Mat& picture, int most_width, const std::string& alt) {
  cv::Mat fitting = picture;
  if (picture.cols > most_width) {
    const double scale = static_cast<double>(most_width) / picture.cols;
    const int height = std::max(1, static_cast<int>(std::lround(scale * picture.rows)));
    cv::resize(picture, fitting, {most_width, height}, 0, 0, cv::INTER_AREA);
  }
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".jpg", fitting, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality}))
    throw std::runtime_error("a picture cannot be encoded");
  return {"image/jpeg", {bytes.begin(), bytes.end()}, alt};
}

}  // namespace armature
