// SPDX-License-Identifier: BSD-3-Clause
// Where detectors put an edge whose place is known to a fraction of a pixel.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>
#include <numbers>
#include <opencv2/core.hpp>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "lines/line_detector.h"

namespace armature {
namespace {

constexpr int kSize = 160;  // pixels

// A straight step from dark to bright in direction `normal` (unit) through `point`, as a lens of 0.6 pixels'
// blur sees it.
cv::Mat StepEdge(const Eigen::Vector2d& normal, const Eigen::Vector2d& point) {
  cv::Mat image(kSize, kSize, CV_8U);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double distance = normal.dot(Eigen::Vector2d(x, y) - point);
      const double level = 80 + 40 * (1 + std::erf(distance / (0.6 * std::numbers::sqrt2)));
      image.at<unsigned char>(y, x) = static_cast<unsigned char>(std::lround(level));
    }
  }
  return image;
}

std::optional<Segment> Longest(const std::vector<Segment>& segments) {
  std::optional<Segment> longest;
  for (const Segment& segment : segments) {
    if (!longest || segment.length() > longest->length()) longest = segment;
  }
  return longest;
}

using DetectorParameters =
    std::tuple<std::string, bool, double>;  // name, published, share of the image's size

LineOptions MakeOptions(const DetectorParameters& parameters) {
  LineOptions options;
  options.detector = *FromName<LineDetectorKind>(std::get<0>(parameters));
  std::tie(std::ignore, options.published, options.edgedrawing_scale) = parameters;
  return options;
}

class LineOffset : public ::testing::TestWithParam<DetectorParameters> {};

// offset along the normal = shift . normal + toward_bright, over edges in all directions.
TEST_P(LineOffset, NoSystematicShift) {
  const LineOptions options = MakeOptions(GetParam());
  const auto detector = MakeLineDetector(options);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), place(70, 90);
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  int found = 0;
  for (int i = 0; i < 150; ++i) {
    const double a = angle(random);
    const Eigen::Vector2d normal(std::cos(a), std::sin(a)), point(place(random), place(random));
    const std::optional<Segment> segment = Longest(detector->Detect(StepEdge(normal, point)));
    if (!segment || segment->length() < 60) continue;
    const double offset = normal.dot(segment->middle() - point);
    if (std::abs(offset) > 3) continue;
    const Eigen::Vector3d row(normal.x(), normal.y(), 1);
    normal_matrix += row * row.transpose();
    right_side += offset * row;
    ++found;
  }
  ASSERT_GT(found, 140);
  const Eigen::Vector3d shift = normal_matrix.ldlt().solve(right_side);
  EXPECT_LT(shift.cwiseAbs().maxCoeff(), 0.05) << "x, y, towards the bright side: " << shift.transpose();
}

// Nothing to see: no segments, no output, no exception; also in the smallest of search regions.
TEST_P(LineOffset, EmptyAndTinyImages) {
  const LineOptions options = MakeOptions(GetParam());
  const auto detector = MakeLineDetector(options);
  const std::ostringstream output;
  std::streambuf* const saved = std::cout.rdbuf(output.rdbuf());
  for (const int side : {1, 2, 5, 9, 13, 16, 17, 24, 48}) {
    const cv::Mat image(side, 64, CV_8U, cv::Scalar(100));
    EXPECT_TRUE(DetectSegments(*detector, image, Camera(), {}, options).empty()) << side;
  }
  std::cout.rdbuf(saved);
  EXPECT_EQ(output.str(), "");
}

std::string FormatName(const ::testing::TestParamInfo<DetectorParameters>& tested) {
  return std::get<0>(tested.param) + (std::get<1>(tested.param) ? "_published" : "_tuned");
}

INSTANTIATE_TEST_SUITE_P(AllDetectors, LineOffset,
                         ::testing::Combine(::testing::ValuesIn(ListNames<LineDetectorKind>()),
                                            ::testing::Bool(),
                                            ::testing::Values(LineOptions{}.edgedrawing_scale)),
                         FormatName);
INSTANTIATE_TEST_SUITE_P(HalfSize, LineOffset,
                         ::testing::Values(DetectorParameters{"edgedrawing", false, 0.5}), FormatName);

}  // namespace
}  // namespace armature
