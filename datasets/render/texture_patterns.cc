// SPDX-License-Identifier: BSD-3-Clause
// Textures of what furniture and rooms are made of.
#include "datasets/render/texture_functions.h"

namespace armature {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kThread = 0.003f;        // metres, of fabrics
constexpr float kJoint = 0.004f;         // metres, between tiles
constexpr float kGap = 0.002f;           // metres, between boards
constexpr float kBoardLength = 9;        // widths
constexpr float kGrainDarkness = 0.35f;  // mean share of the second colour in wood

// From 0 slowly up to 1 and quickly down: the wood of a year.
float YearRing(float radius) {
  const float t = radius - static_cast<float>(Floor(radius));
  return t < 0.85f ? t * t / (0.85f * 0.85f) : (1 - t) / 0.15f;
}

// About 0: how much darker than its mean the wood is; grain along x. Year rings around an axis that lies
// outside of the board, fibres, slow changes.
float Grain(const Vector3f& p, float distance, float footprint, std::uint32_t seed) {
  const float s = distance;
  const Vector2f axis = s * Vector2f(10 * Unit(Mixed(seed)) - 5, 4 + 4 * Unit(Mixed(seed + 1)));
  float grain = 0.3f * FadedNoise(p, Vector3f(1.0f, 0.1f, 0.1f), footprint, seed);
  grain += 0.25f * FadedNoise(p, Vector3f(0.12f, 0.003f, 0.003f), footprint, seed + 2);
  const float fade = Fade(footprint, 0.7f * s);
  if (fade > 0) {
    const float wander = 1.5f * SmoothNoise(p.cwiseQuotient(Vector3f(25 * s, 4 * s, 4 * s)), seed + 3);
    const float radius = (p.tail<2>() + axis).norm() / s + wander;
    grain += fade * (YearRing(radius) - 0.36f);
  }
  return grain;
}

Vector3f Solid(const Vector2f& flat) { return {flat.x(), flat.y(), 0}; }

}  // namespace

Rgb PlainTexture(const Paint& paint, const TexturePoint& at) {
  const float patches = FadedNoise(at.solid, Vector3f::Constant(0.35f), at.footprint, paint.seed);
  const float roller = FadedNoise(at.solid, Vector3f::Constant(0.008f), at.footprint, paint.seed + 1);
  return paint.colour * (1 + 0.015f * patches + 0.02f * roller);
}

Rgb WoodTexture(const Paint& paint, const TexturePoint& at) {
  const float grain = Grain(at.solid, paint.scale, at.footprint, paint.seed);
  return Mix(paint.colour, paint.second, std::clamp(kGrainDarkness + 0.6f * grain, 0.0f, 1.0f));
}

// Warp and weft take turns in being on top; a thread is darker at its sides, where it goes below the other.
Rgb FabricTexture(const Paint& paint, const TexturePoint& at) {
  const float melange = FadedNoise(at.solid, Vector3f::Constant(0.01f), at.footprint, paint.seed) +
                        0.5f * FadedNoise(at.solid, Vector3f::Constant(0.07f), at.footprint, paint.seed + 1);
  float across = 0, warp = 0;
  const float fade = Fade(at.footprint, kThread);
  if (fade > 0) {
    const Vector2f p = at.flat / kThread;
    const int i = Floor(p.x()), j = Floor(p.y());
    const bool warp_on_top = ((i + j) & 1) == 0;
    const float t = warp_on_top ? p.x() - static_cast<float>(i) : p.y() - static_cast<float>(j);
    across = fade * (4 * t * (1 - t) - 2.0f / 3);
    warp = fade * (warp_on_top ? 0.5f : -0.5f);
  }
  return Mix(paint.colour, paint.second, 0.3f + 0.4f * warp) * (1 + 0.3f * across + 0.08f * melange);
}

Rgb CarpetTexture(const Paint& paint, const TexturePoint& at) {
  const auto noise = [&](float size, std::uint32_t layer) {
    return FadedNoise(Solid(at.flat), Vector3f::Constant(size), at.footprint, paint.seed + layer);
  };
  const float pile = 0.7f * noise(0.004f, 0) + 0.5f * noise(0.011f, 1) + 0.15f * noise(0.05f, 2);
  const Rgb yarn = Mix(paint.colour, paint.second, std::clamp(0.4f + 0.6f * pile, 0.0f, 1.0f));
  return yarn * (1 + 0.04f * noise(0.4f, 3) + 0.15f * noise(0.003f, 4));
}

Rgb TilesTexture(const Paint& paint, const TexturePoint& at) {
  const Vector2f p = at.flat / paint.scale;
  const float width = kJoint / paint.scale, footprint = at.footprint / paint.scale;
  const float joint =
      1 - (1 - StripeShare(p.x(), width, footprint)) * (1 - StripeShare(p.y(), width, footprint));
  const float shade =
      Fade(at.footprint, paint.scale) * (CellNoise(Floor(p.x()), Floor(p.y()), paint.seed) - 0.5f);
  const float cloud =
      FadedNoise(Solid(at.flat), Vector3f(0.12f, 0.05f, 1), at.footprint, paint.seed + 1) +
      0.6f * FadedNoise(Solid(at.flat), Vector3f(0.02f, 0.02f, 1), at.footprint, paint.seed + 2);
  return Mix(paint.colour * (1 + 0.1f * shade + 0.03f * cloud), paint.second, joint);
}

Rgb BoardsTexture(const Paint& paint, const TexturePoint& at) {
  const float width = paint.scale, length = kBoardLength * width;
  const int row = Floor(at.flat.y() / width);
  const float along = at.flat.x() / length + CellNoise(row, 0, paint.seed);
  const std::uint32_t board = Hash(Floor(along), row, 1, paint.seed);
  const float gaps = 1 - (1 - StripeShare(at.flat.y() / width, kGap / width, at.footprint / width)) *
                             (1 - StripeShare(along, kGap / length, at.footprint / length));
  const float shade = Fade(at.footprint, width) * (Unit(board) - 0.5f);
  const Vector3f p(at.flat.x(), at.flat.y() - width * static_cast<float>(row), 0);
  const float grain = Grain(p, 0.12f * width, at.footprint, board);
  const Rgb wood =
      Mix(paint.colour, paint.second, std::clamp(0.35f + 0.5f * shade + 0.25f * grain, 0.0f, 1.0f));
  return wood * (1 + 0.15f * shade) * (1 - 0.6f * gaps);
}

}  // namespace armature
