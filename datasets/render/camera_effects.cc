// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/camera_effects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "drawing/noise.h"
#include "geometry/random.h"

namespace armature {
namespace {

constexpr float kKnee = 0.6f;  // radiance above which highlights are compressed rather than cut off

std::uint64_t FrameSeed(std::uint64_t seed, int frame) {
  return seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(frame) * 0xbf58476d1ce4e5b9u;
}

// Three slow waves of random phases and periods that do not fit each other.
double Exposure(double change, std::uint64_t seed, int frame) {
  Random random(seed);
  double sum = 0;
  for (const double period : {47.0, 89.0, 161.0}) {  // frames
    const double phase = random.Uniform(0, 2 * std::numbers::pi);
    sum += std::sin(2 * std::numbers::pi * frame / period + phase);
  }
  return std::max(0.1, 1 + change * std::sqrt(2.0 / 3) * sum);
}

// Exposure times what of the light arrives at each pixel: less with the square of the distance to the
// centre.
void Expose(double exposure, double vignetting, cv::Mat3f* picture) {
  const double cx = 0.5 * (picture->cols - 1), cy = 0.5 * (picture->rows - 1);
  const double corner = cx * cx + cy * cy + 1e-9;
  picture->forEach([&](cv::Vec3f& pixel, const int* at) {
    const double dx = at[1] - cx, dy = at[0] - cy;
    pixel *= static_cast<float>(exposure * (1 - vignetting * (dx * dx + dy * dy) / corner));
  });
}

// A line of `length` pixels through the middle, each of its points shared between four pixels.
cv::Mat1f MotionKernel(double length, double angle) {
  constexpr int kPoints = 33;
  const int half = static_cast<int>(std::ceil(0.5 * length)) + 1;
  cv::Mat1f kernel(2 * half + 1, 2 * half + 1, 0.0f);
  for (int i = 0; i < kPoints; ++i) {
    const double along = length * (static_cast<double>(i) / (kPoints - 1) - 0.5);
    const double x = half + along * std::cos(angle), y = half + along * std::sin(angle);
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    for (int k = 0; k < 4; ++k) {
      const int c = column + (k & 1), r = row + (k >> 1);
      if (c > 2 * half || r > 2 * half) continue;
      kernel(r, c) += static_cast<float>((1 - std::abs(x - c)) * (1 - std::abs(y - r)));
    }
  }
  kernel /= cv::sum(kernel)[0];
  return kernel;
}

void Blur(const CameraEffects& effects, Random* random, cv::Mat3f* picture) {
  const double length = effects.motion_blur_px * random->Uniform(0, 2);
  const double angle = random->Uniform(0, std::numbers::pi);
  if (length > 0.05) {
    cv::filter2D(*picture, *picture, -1, MotionKernel(length, angle), {-1, -1}, 0, cv::BORDER_REPLICATE);
  }
  if (effects.blur_px > 0) {
    cv::GaussianBlur(*picture, *picture, {0, 0}, effects.blur_px, effects.blur_px, cv::BORDER_REPLICATE);
  }
}

// The grey level, 0..255, of a radiance: sRGB, with a soft shoulder.
float GreyLevel(float radiance) {
  const float over = std::max(radiance - kKnee, 0.0f);
  const float x = std::min(radiance, kKnee) + (1 - kKnee) * (1 - std::exp(-over / (1 - kKnee)));
  return 255 * (x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f);
}

void ApplyToneCurve(cv::Mat3f* picture) {
  constexpr int kSteps = 4096;
  constexpr float kBrightest = 8;  // where the curve is flat; steps are even in the square root
  static const std::vector<float> curve = [] {
    std::vector<float> levels;
    for (int i = 0; i <= kSteps + 1; ++i) {
      const float root = static_cast<float>(i) / kSteps;
      levels.push_back(GreyLevel(kBrightest * root * root));
    }
    return levels;
  }();
  picture->forEach([](cv::Vec3f& pixel, const int*) {
    for (int c = 0; c < 3; ++c) {
      const float step = kSteps * std::sqrt(std::clamp(pixel[c] / kBrightest, 0.0f, 1.0f));
      const auto i = static_cast<size_t>(step);
      pixel[c] = curve[i] + (curve[i + 1] - curve[i]) * (step - static_cast<float>(i));
    }
  });
}

// Normal numbers, to be drawn from by hashes: much faster than drawing each anew.
const std::vector<float>& NormalNumbers() {
  static const std::vector<float> numbers = [] {
    Random random(1);
    std::vector<float> drawn(1 << 16);
    for (float& number : drawn) number = static_cast<float>(random.Normal(0, 1));
    return drawn;
  }();
  return numbers;
}

// Of sigma 1 a channel. The channels share most of it, and neighbours some, as demosaicing and compression
// leave it.
cv::Mat3f UnitNoise(const cv::Size& size, std::uint32_t seed) {
  constexpr float kShared = 0.8f, kOwn = 0.6f, kNeighbour = 0.25f;
  const std::vector<float>& normal = NormalNumbers();
  cv::Mat3f noise(size);
  noise.forEach([&](cv::Vec3f& pixel, const int* at) {
    const std::uint32_t a = Hash(at[1], at[0], 0, seed), b = Hash(at[1], at[0], 1, seed);
    const float shared = kShared * normal[a & 0xffff];
    pixel = {shared + kOwn * normal[a >> 16], shared + kOwn * normal[b & 0xffff],
             shared + kOwn * normal[b >> 16]};
  });
  const cv::Matx13f kernel =
      cv::Matx13f(kNeighbour, 1, kNeighbour) * (1 / std::sqrt(1 + 2 * kNeighbour * kNeighbour));
  cv::sepFilter2D(noise, noise, -1, kernel, kernel);
  return noise;
}

// Somewhat more in the dark, where the curve is steep.
cv::Mat3b WithNoise(const cv::Mat3f& levels, double sigma, std::uint32_t seed) {
  cv::Mat3b picture(levels.size());
  const cv::Mat3f noise = UnitNoise(levels.size(), seed);
  picture.forEach([&](cv::Vec3b& pixel, const int* at) {
    const cv::Vec3f &level = levels(at[0], at[1]), &unit = noise(at[0], at[1]);
    for (int c = 0; c < 3; ++c) {
      const float here = static_cast<float>(sigma) * (1.3f - 0.6f * level[c] / 255);
      pixel[c] = cv::saturate_cast<uchar>(level[c] + here * unit[c]);
    }
  });
  return picture;
}

}  // namespace

cv::Mat3b Develop(const cv::Mat3f& radiance, const CameraEffects& effects, std::uint64_t seed, int frame) {
  Random random(FrameSeed(seed, frame));
  cv::Mat3f picture = radiance.clone();
  Expose(effects.exposure * Exposure(effects.exposure_change, seed, frame), effects.vignetting, &picture);
  Blur(effects, &random, &picture);
  ApplyToneCurve(&picture);
  return WithNoise(picture, effects.noise, static_cast<std::uint32_t>(random.Uniform(0, 4294967296.0)));
}

}  // namespace armature
