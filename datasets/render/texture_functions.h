// SPDX-License-Identifier: BSD-3-Clause
// The single textures (of textures.cc only), and what they have in common.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "datasets/render/textures.h"
#include "drawing/noise.h"

namespace armature {

// Where to draw: the point in the part's frame, as well as on the surface along the two axes that are most
// along it.
struct TexturePoint {
  Eigen::Vector3f solid{0, 0, 0};
  Eigen::Vector2f flat{0, 0};
  float footprint = 0;  // metres
};

Rgb PlainTexture(const Paint& paint, const TexturePoint& at);
Rgb WoodTexture(const Paint& paint, const TexturePoint& at);
Rgb FabricTexture(const Paint& paint, const TexturePoint& at);
Rgb CarpetTexture(const Paint& paint, const TexturePoint& at);
Rgb TilesTexture(const Paint& paint, const TexturePoint& at);
Rgb BoardsTexture(const Paint& paint, const TexturePoint& at);
Rgb PrintTexture(const Paint& paint, const TexturePoint& at);
Rgb PictureTexture(const Paint& paint, const TexturePoint& at);
Rgb ScreenTexture(const Paint& paint, const TexturePoint& at);
Rgb KeyboardTexture(const Paint& paint, const TexturePoint& at);

inline Rgb Mix(const Rgb& a, const Rgb& b, float share_of_b) { return a + (b - a) * share_of_b; }

// How much is left of variation whose features are of `size`: all while they are four times the footprint.
inline float Fade(float footprint, float size) { return std::clamp(1.5f - 2 * footprint / size, 0.0f, 1.0f); }

// Noise with features of `size`, faded; no time is lost on what is not seen.
inline float FadedNoise(const Eigen::Vector3f& p, const Eigen::Vector3f& size, float footprint,
                        std::uint32_t seed) {
  const float fade = Fade(footprint, size.minCoeff());
  return fade > 0 ? fade * SmoothNoise(p.cwiseQuotient(size), seed) : 0;
}

// The share of [x - footprint / 2, x + footprint / 2] that stripes of `width` around all whole numbers cover.
inline float StripeShare(float x, float width, float footprint) {
  const auto covered = [&](float end) {  // from 0 to `end`
    const float cell = static_cast<float>(Floor(end));
    return cell * width + std::min(end - cell, width);
  };
  const float f = std::max(footprint, 1e-4f), start = x + 0.5f * width;
  return (covered(start + 0.5f * f) - covered(start - 0.5f * f)) / f;
}

// 0 below, 1 above the edge, in between over a footprint.
inline float SoftStep(float x, float edge, float footprint) {
  return std::clamp((x - edge) / std::max(footprint, 1e-6f) + 0.5f, 0.0f, 1.0f);
}

inline float InRectangle(const Eigen::Vector2f& p, const Eigen::Vector2f& low, const Eigen::Vector2f& high,
                         float footprint) {
  return SoftStep(p.x(), low.x(), footprint) * SoftStep(-p.x(), -high.x(), footprint) *
         SoftStep(p.y(), low.y(), footprint) * SoftStep(-p.y(), -high.y(), footprint);
}

}  // namespace armature
