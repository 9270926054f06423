// SPDX-License-Identifier: BSD-3-Clause
// Heat maps, a keypoint network's output: one map of 64x64 values a keypoint, with a blob where it is seen.
// They cover a square of the image; map pixel (i, j) covers 1/64 of its width and height, so that its centre
// is at
//   u = left + (i + 1/2) side / 64,  v = top + (j + 1/2) side / 64.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "geometry/box.h"

namespace armature {

constexpr int kHeatMapSize = 64;  // pixels

// The square about the box's centre that a keypoint network gets to see: a quarter wider than the box's
// longer side, as Newell et al. crop people.
Box CropAround(const Box& box);

// The crop as a picture of size x size pixels, 8 bit, three channels; zero beyond the image's border. `gray`:
// 8 bit, one channel.
cv::Mat CropPicture(const cv::Mat& gray, const Box& crop, int size);

// A Gaussian of one map pixel's deviation about each keypoint (Newell et al.'s target), 255 at its top; zero
// everywhere where the keypoint is outside of the crop. `pixels`: in the image. Returns 8 bit maps, one below
// the other: 64 K rows, 64 columns.
cv::Mat DrawHeatMaps(const std::vector<Eigen::Vector2d>& pixels, const Box& crop);

struct Peak {
  Eigen::Vector2d pixel{0, 0};  // in the image
  double score = 0;             // 0..1, the map's largest value
};

// The largest value of each map, moved by a quarter of a map pixel towards the larger neighbour in each
// direction (Newell et al. 2016, section 3.3). `maps`: as DrawHeatMaps returns them.
std::vector<Peak> ReadPeaks(const cv::Mat& maps, const Box& crop);

}  // namespace armature
