// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/render/textures.h"

namespace armature {
namespace {

using Eigen::Vector3f;

Material Of(Texture texture, double scale) {
  return {texture, {0.7, 0.5, 0.4}, {0.5, 0.35, 0.3}, scale, 0, 5};
}

struct Statistics {
  Rgb mean{0, 0, 0};
  float deviation = 0;  // of green
};

// Over a square metre of the x-y plane.
Statistics Measure(const Paint& paint, float footprint) {
  constexpr int kSide = 90;
  Statistics statistics;
  double sum = 0, squares = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double a = 0.7548776662 * i, b = 0.5698402910 * i;  // the R2 sequence
    const Eigen::Vector3d point(a - std::floor(a) - 0.5, b - std::floor(b) - 0.5, 0);
    const Rgb colour = ColourAt(paint, point.cast<float>(), Vector3f::UnitZ(), footprint);
    statistics.mean += colour;
    sum += colour[1];
    squares += static_cast<double>(colour[1]) * colour[1];
  }
  statistics.mean /= kSide * kSide;
  const double mean = sum / (kSide * kSide);
  statistics.deviation =
      static_cast<float>(std::sqrt(std::max(0.0, squares / (kSide * kSide) - mean * mean)));
  return statistics;
}

constexpr std::array kMaterials = {Texture::kPlain,  Texture::kWood,  Texture::kFabric,
                                   Texture::kCarpet, Texture::kTiles, Texture::kBoards};

TEST(Textures, HaveAMeanBetweenTheirTwoColours) {
  for (const Texture texture : kMaterials) {
    const Paint paint(Of(texture, 0.1));
    const Statistics near = Measure(paint, 0.001f);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(near.mean[c], 1.03f * paint.colour[c]) << static_cast<int>(texture);
      EXPECT_GT(near.mean[c], 0.7f * paint.second[c] + 0.3f * paint.colour[c]) << static_cast<int>(texture);
      EXPECT_NEAR(near.mean[c], paint.mean[c], 0.06f * near.mean[c]) << static_cast<int>(texture);
    }
  }
}

TEST(Textures, FadeToTheirMeanWithTheFootprint) {
  for (const Texture texture : kMaterials) {
    const Paint paint(Of(texture, 0.02));
    const Statistics near = Measure(paint, 0.0005f), far = Measure(paint, 0.5f);
    EXPECT_GT(near.deviation, 0.002f) << static_cast<int>(texture);
    EXPECT_LT(far.deviation, 0.25f * near.deviation) << static_cast<int>(texture);
    EXPECT_NEAR(far.mean[1], near.mean[1], 0.05f * near.mean[1]) << static_cast<int>(texture);
  }
}

TEST(Textures, TilesHaveTheirJointsAtMultiplesOfTheScale) {
  const Paint paint(Of(Texture::kTiles, 0.3));
  const auto colour_at = [&](float x, float y) {
    return ColourAt(paint, {x, y, 0}, Vector3f::UnitZ(), 1e-4f);
  };
  for (const float joint : {-0.3f, 0.0f, 0.3f, 0.9f}) {
    EXPECT_TRUE(colour_at(joint, 0.1f).isApprox(paint.second, 1e-3f));
    EXPECT_TRUE(colour_at(0.1f, joint + 0.001f).isApprox(paint.second, 1e-3f));
    EXPECT_TRUE(colour_at(joint + 0.003f, 0.1f).isApprox(paint.colour, 0.12f));
  }
  EXPECT_FALSE(paint.colour.isApprox(paint.second, 0.3f));
}

TEST(Textures, AHalfSeenJointCountsByHalf) {
  const Paint paint(Of(Texture::kTiles, 0.3));
  const float covered = 0.004f / 0.008f;  // a joint of 4 mm in a footprint of 8 mm
  const Rgb expected = paint.colour + (paint.second - paint.colour) * covered;
  EXPECT_TRUE(ColourAt(paint, {0, 0.1f, 0}, Vector3f::UnitZ(), 0.008f).isApprox(expected, 0.06f));
}

TEST(Textures, WhatIsDrawnInThePlaneIsPlainOnItsSides) {
  const Paint paint(Of(Texture::kPrint, 0.02));
  for (float x = 0; x < 0.2f; x += 0.003f) {
    EXPECT_TRUE(ColourAt(paint, {x, 0, 0}, Vector3f::UnitY(), 0.001f).isApprox(paint.colour, 0.05f));
  }
}

TEST(Textures, SeedsTellPartsApart) {
  Material material = Of(Texture::kWood, 0.02);
  const Paint one(material);
  material.seed = 6;
  const Paint other(material);
  int different = 0;
  for (int i = 0; i < 50; ++i) {
    const Vector3f p(0, 0.013f * static_cast<float>(i), 0);
    different += !ColourAt(one, p, Vector3f::UnitZ(), 0.001f)
                      .isApprox(ColourAt(other, p, Vector3f::UnitZ(), 0.001f), 0.02f);
  }
  EXPECT_GT(different, 25);
}

}  // namespace
}  // namespace armature
