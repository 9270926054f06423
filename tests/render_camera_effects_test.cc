// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datasets/render/camera_effects.h"

namespace armature {
namespace {

constexpr CameraEffects kNone{0, 0, 0, 0, 0};
constexpr float kMidGrey = 0.2122f;  // 127 in sRGB

cv::Mat3f Flat(float radiance) { return cv::Mat3f(80, 100, cv::Vec3f(radiance, radiance, radiance)); }

double Level(const cv::Mat3b& picture) { return cv::mean(picture)[1]; }

TEST(Develop, IsSrgbWithRoomForHighlights) {
  EXPECT_NEAR(Level(Develop(Flat(kMidGrey), kNone, 1, 0)), 127, 0.6);
  EXPECT_NEAR(Level(Develop(Flat(0), kNone, 1, 0)), 0, 0);
  const double white = Level(Develop(Flat(1), kNone, 1, 0)), lamp = Level(Develop(Flat(10), kNone, 1, 0));
  EXPECT_GT(white, 225);
  EXPECT_LT(white, 250);
  EXPECT_NEAR(lamp, 255, 0.5);
}

TEST(Develop, NoiseOfMidGreyHasTheSigmaAskedForAndNoBias) {
  CameraEffects effects = kNone;
  effects.noise = 4;
  cv::Scalar mean, deviation;
  cv::meanStdDev(Develop(Flat(kMidGrey), effects, 1, 0), mean, deviation);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], 127, 0.7);
    EXPECT_NEAR(deviation[c], 4, 0.3);
  }
}

TEST(Develop, NoiseOfNeighboursIsAlikeThatOfOtherPixelsIsNot) {
  CameraEffects effects = kNone;
  effects.noise = 8;
  cv::Mat3b picture = Develop(Flat(kMidGrey), effects, 1, 0);
  const auto covariance = [&](int shift) {
    double sum = 0;
    for (int y = 0; y < picture.rows; ++y) {
      for (int x = 0; x + shift < picture.cols; ++x) {
        sum += (picture(y, x)[1] - 127.0) * (picture(y, x + shift)[1] - 127.0);
      }
    }
    return sum / (picture.rows * (picture.cols - shift));
  };
  EXPECT_GT(covariance(1) / covariance(0), 0.2);
  EXPECT_LT(covariance(1) / covariance(0), 0.7);
  EXPECT_NEAR(covariance(5) / covariance(0), 0, 0.06);
}

// Sigma of the derivative of an edge's profile, pixels.
double EdgeWidth(const CameraEffects& effects) {
  cv::Mat3f edge(60, 60, cv::Vec3f(0.02f, 0.02f, 0.02f));
  edge.colRange(30, 60) = cv::Vec3f(0.05f, 0.05f, 0.05f);
  const cv::Mat3b picture = Develop(edge, effects, 1, 0);
  double sum = 0, mean = 0, square = 0;
  for (int x = 20; x < 40; ++x) {
    const double step = cv::mean(picture.col(x + 1))[1] - cv::mean(picture.col(x))[1];
    sum += step;
    mean += step * x;
    square += step * x * x;
  }
  return std::sqrt(square / sum - mean * mean / (sum * sum));
}

TEST(Develop, BlurWidensAnEdgeAsAskedFor) {
  CameraEffects effects = kNone;
  EXPECT_NEAR(EdgeWidth(effects), 0, 1e-6);
  effects.blur_px = 1.5;
  EXPECT_NEAR(EdgeWidth(effects), 1.5, 0.15);
}

TEST(Develop, MotionBlurChangesWithTheFrame) {
  CameraEffects effects = kNone;
  effects.motion_blur_px = 4;
  cv::Mat3f dot(41, 41, cv::Vec3f(0, 0, 0));
  dot(20, 20) = cv::Vec3f(1, 1, 1);
  double least = 255, most = 0, kept = 0;
  for (int frame = 0; frame < 20; ++frame) {
    const double brightest = Develop(dot, effects, 1, frame)(20, 20)[1];
    least = std::min(least, brightest);
    most = std::max(most, brightest);
    kept += brightest > 0;
  }
  EXPECT_LT(least, 140);
  EXPECT_GT(most, 160);
  EXPECT_EQ(kept, 20);
}

TEST(Develop, VignettingDarkensTheCornersOnly) {
  CameraEffects effects = kNone;
  effects.vignetting = 0.5;
  const cv::Mat3b picture = Develop(Flat(2 * kMidGrey), effects, 1, 0);
  EXPECT_NEAR(picture(0, 0)[1], 127, 1);
  EXPECT_NEAR(picture(40, 50)[1], Develop(Flat(2 * kMidGrey), kNone, 1, 0)(40, 50)[1], 1);
}

TEST(Develop, ExposureChangesSlowlyAndAsMuchAsAskedFor) {
  CameraEffects effects = kNone;
  effects.exposure_change = 0.1;
  double sum = 0, squares = 0, largest_step = 0, before = 0;
  constexpr int kFrames = 400;
  for (int frame = 0; frame < kFrames; ++frame) {
    const double exposure = std::pow(Level(Develop(Flat(kMidGrey), effects, 3, frame)) / 127, 2.2);
    if (frame > 0) largest_step = std::max(largest_step, std::abs(exposure - before));
    before = exposure;
    sum += exposure;
    squares += exposure * exposure;
  }
  EXPECT_NEAR(sum / kFrames, 1, 0.04);
  EXPECT_NEAR(std::sqrt(squares / kFrames - std::pow(sum / kFrames, 2)), 0.1, 0.03);
  EXPECT_LT(largest_step, 0.04);
}

TEST(Develop, IsTheSameForASeedAndFrameOnly) {
  const auto noisy = [](std::uint64_t seed, int frame) {
    return Develop(Flat(kMidGrey), CameraEffects(), seed, frame);
  };
  const auto difference = [](const cv::Mat3b& a, const cv::Mat3b& b) { return cv::norm(a, b, cv::NORM_INF); };
  EXPECT_EQ(difference(noisy(1, 5), noisy(1, 5)), 0);
  EXPECT_GT(difference(noisy(1, 5), noisy(1, 6)), 0);
  EXPECT_GT(difference(noisy(1, 5), noisy(2, 5)), 0);
}

}  // namespace
}  // namespace armature
