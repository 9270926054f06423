// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "bench/keypoints/hourglass_network.h"

namespace armature {
namespace {

// The same layers, narrow and on a small picture, for speed.
HourglassOptions SmallHourglass() {
  return {.stacks = 2, .depth = 2, .features = 16, .maps = 5, .input = 64};
}

cv::Mat NoisePicture(int size, std::uint64_t seed) {
  cv::Mat picture(size, size, CV_8UC3);
  cv::RNG(seed).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

TEST(Hourglass, TwoStacksHaveThePublishedNumberOfParameters) {
  const HourglassNetwork network(HourglassOptions{});
  EXPECT_EQ(network.cost().parameters, 6730912);  // 6.73 M
  EXPECT_EQ(network.cost().multiply_adds, 8988917760);
}

TEST(Hourglass, EightStacksHaveThePublishedNumberOfParameters) {
  const HourglassNetwork network({.stacks = 8});
  EXPECT_EQ(network.cost().parameters, 25594624);  // 25.6 M
  EXPECT_EQ(network.cost().multiply_adds, 28094496768);
}

TEST(Hourglass, OpenCvCountsAboutTheSameOperations) {
  const HourglassNetwork network(HourglassOptions{});
  const double operations = 2 * static_cast<double>(network.cost().multiply_adds);
  EXPECT_GT(static_cast<double>(network.OperationsByOpenCv()), operations);  // of all layers
  EXPECT_LT(static_cast<double>(network.OperationsByOpenCv()), 1.03 * operations);
}

void ExpectMaps(const HourglassOptions& options, const std::vector<int>& shape) {
  HourglassNetwork network(options);
  const cv::Mat maps = network.Forward(NoisePicture(options.input, 1));
  EXPECT_EQ(std::vector<int>(maps.size.p, maps.size.p + maps.dims), shape);
  EXPECT_TRUE(cv::checkRange(maps));
}

TEST(Hourglass, MapsHaveAQuarterOfThePicturesSize) {
  ExpectMaps(HourglassOptions{}, {1, 16, 64, 64});
  ExpectMaps(SmallHourglass(), {1, 5, 16, 16});
}

TEST(Hourglass, TheSamePictureGivesTheSameMapsAndAnotherOneOthers) {
  HourglassNetwork network(SmallHourglass()), twin(SmallHourglass());
  const cv::Mat first = network.Forward(NoisePicture(64, 1)).clone();
  const cv::Mat other = network.Forward(NoisePicture(64, 2)).clone();
  const auto difference = [&](const cv::Mat& maps) { return cv::norm(maps, first, cv::NORM_INF); };
  EXPECT_EQ(difference(network.Forward(NoisePicture(64, 1))), 0);
  EXPECT_EQ(difference(twin.Forward(NoisePicture(64, 1))), 0);
  EXPECT_GT(difference(other), 0.01 * cv::norm(first, cv::NORM_INF));
}

TEST(Hourglass, AnotherSeedIsAnotherNetwork) {
  HourglassOptions options = SmallHourglass();
  const cv::Mat first = HourglassNetwork(options).Forward(NoisePicture(64, 1)).clone();
  options.seed = 2;
  HourglassNetwork other(options);
  EXPECT_GT(cv::norm(other.Forward(NoisePicture(64, 1)), first, cv::NORM_INF),
            0.01 * cv::norm(first, cv::NORM_INF));
}

}  // namespace
}  // namespace armature
