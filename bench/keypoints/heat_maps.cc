// SPDX-License-Identifier: BSD-3-Clause
#include "bench/keypoints/heat_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace armature {
namespace {

constexpr int kSize = kHeatMapSize;

using Profile = std::array<double, kSize>;

Profile Gaussian(double center) {
  Profile profile;
  for (int i = 0; i < kSize; ++i) {
    profile[static_cast<size_t>(i)] = std::exp(-0.5 * (i - center) * (i - center));
  }
  return profile;
}

void DrawBlob(const Eigen::Vector2d& at, cv::Mat map) {
  const Profile across = Gaussian(at.x()), down = Gaussian(at.y());
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double value = across[static_cast<size_t>(x)] * down[static_cast<size_t>(y)];
      map.at<uchar>(y, x) = cv::saturate_cast<uchar>(255 * value);
    }
  }
}

// A quarter towards the larger of the two neighbours, nothing between equals and at the map's border.
double Shift(const cv::Mat& map, const cv::Point& at, const cv::Point& step) {
  const cv::Point before = at - step, after = at + step;
  const cv::Rect inside(0, 0, map.cols, map.rows);
  if (!inside.contains(before) || !inside.contains(after)) return 0;
  const int difference = map.at<uchar>(after) - map.at<uchar>(before);
  return difference > 0 ? 0.25 : difference < 0 ? -0.25 : 0;
}

}  // namespace

Box CropAround(const Box& box) {
  const double side = 1.25 * std::max(box.width, box.height);
  const Eigen::Vector2d corner = box.center() - Eigen::Vector2d::Constant(side / 2);
  return {corner.x(), corner.y(), side, side};
}

cv::Mat CropPicture(const cv::Mat& gray, const Box& crop, int size) {
  const double scale = crop.width / size;
  const cv::Matx23d image_from_picture(scale, 0, crop.x + 0.5 * scale, 0, scale, crop.y + 0.5 * scale);
  cv::Mat picture, three_channels;
  cv::warpAffine(gray, picture, image_from_picture, {size, size}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  cv::cvtColor(picture, three_channels, cv::COLOR_GRAY2BGR);
  return three_channels;
}

cv::Mat DrawHeatMaps(const std::vector<Eigen::Vector2d>& pixels, const Box& crop) {
  cv::Mat maps = cv::Mat::zeros(static_cast<int>(pixels.size()) * kSize, kSize, CV_8U);
  int row = 0;
  for (const Eigen::Vector2d& pixel : pixels) {
    const Eigen::Vector2d at = (pixel - Eigen::Vector2d(crop.x, crop.y)) * (kSize / crop.width);
    if (crop.Contains(pixel)) {
      DrawBlob(at - Eigen::Vector2d::Constant(0.5), maps.rowRange(row, row + kSize));
    }
    row += kSize;
  }
  return maps;
}

std::vector<Peak> ReadPeaks(const cv::Mat& maps, const Box& crop) {
  std::vector<Peak> peaks;
  const double map_pixel = crop.width / kSize;
  for (int row = 0; row < maps.rows; row += kSize) {
    const cv::Mat map = maps.rowRange(row, row + kSize);
    double largest = 0;
    cv::Point at;
    cv::minMaxLoc(map, nullptr, &largest, nullptr, &at);
    const Eigen::Vector2d shifted(at.x + Shift(map, at, {1, 0}), at.y + Shift(map, at, {0, 1}));
    peaks.push_back(
        {Eigen::Vector2d(crop.x, crop.y) + map_pixel * (shifted + Eigen::Vector2d(0.5, 0.5)), largest / 255});
  }
  return peaks;
}

}  // namespace armature
