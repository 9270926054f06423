// SPDX-License-Identifier: BSD-3-Clause
// Textures of what people make: print, paintings, screens, keyboards. Sizes are in units of the scale.
#include "datasets/render/texture_functions.h"

namespace armature {
namespace {

using Eigen::Vector2f;

// Share of ink in lines of words, a line a unit.
float Ink(const Vector2f& p, float footprint, std::uint32_t seed) {
  const int line = Floor(p.y());
  const float fade = Fade(footprint, 0.5f);
  const float letters = 1 - StripeShare(p.y(), 0.5f, footprint);
  const bool blank = CellNoise(0, line, seed) < 0.12f;
  const bool space = CellNoise(Floor(2 * p.x()), line, seed + 1) < 0.2f;
  const bool thin = CellNoise(Floor(8 * p.x()), line, seed + 2) < 0.5f;
  const float density = 0.42f + fade * ((space ? 0.0f : (thin ? 0.3f : 0.75f)) - 0.42f);
  return letters * density * (blank ? 1 - Fade(footprint, 2) : 1.0f);
}

// One of a few colours that go together.
Rgb Palette(const Paint& paint, std::uint32_t hash) {
  const float t = Unit(hash);
  const Rgb base = Mix(paint.colour, paint.second, t);
  const Rgb turned(base[2], base[0], base[1]);
  const Rgb shade = Mix(base, turned, 0.35f * Unit(Mixed(hash)));
  return shade * (0.5f + Unit(Mixed(hash + 1)));
}

float Ridge(float x, int layer, std::uint32_t seed) {
  return SmoothNoise({0.5f * x, 0, 7.3f * static_cast<float>(layer)}, seed) +
         0.3f * SmoothNoise({2 * x, 0, 3.1f * static_cast<float>(layer)}, seed + 1);
}

// A pale sky, hills that are darker the closer they are.
Rgb Landscape(const Paint& paint, const Vector2f& p, float footprint) {
  const float height = std::clamp(0.25f * p.y() + 0.4f, 0.0f, 1.0f);
  Rgb colour = Mix(Rgb(0.85f, 0.8f, 0.72f), Mix(Rgb(0.45f, 0.6f, 0.75f), paint.colour, 0.4f), height);
  for (int layer = 0; layer < 4; ++layer) {
    const float ridge = 0.8f - 0.8f * static_cast<float>(layer) + 0.6f * Ridge(p.x(), layer, paint.seed);
    const float near = static_cast<float>(layer) / 3;
    const Rgb hill = Mix(Mix(paint.colour, colour, 0.5f), paint.second, near) * (1 - 0.3f * near);
    colour = Mix(colour, hill, 1 - SoftStep(p.y(), ridge, footprint));
  }
  return colour;
}

// Overlapping discs on a plain ground.
Rgb Discs(const Paint& paint, const Vector2f& p, float footprint) {
  Rgb colour = Mix(paint.colour, Rgb(0.7f, 0.68f, 0.62f), 0.5f);
  for (std::uint32_t i = 0; i < 7; ++i) {
    const std::uint32_t h = Mixed(paint.seed + 31 * i);
    const Vector2f centre(5 * Unit(Mixed(h)) - 2.5f, 5 * Unit(Mixed(h + 1)) - 2.5f);
    const float radius = 0.4f + Unit(Mixed(h + 2));
    colour =
        Mix(colour, Palette(paint, h + 3), 0.85f * (1 - SoftStep((p - centre).norm(), radius, footprint)));
  }
  return colour;
}

// Rectangles in a crooked grid with dark lines between.
Rgb Rectangles(const Paint& paint, const Vector2f& p, float footprint) {
  const int row = Floor(p.y());
  const float along = 0.6f * p.x() + CellNoise(row, 0, paint.seed);
  const Rgb fill = Palette(paint, Hash(Floor(along), row, 5, paint.seed));
  const float lines =
      1 - (1 - StripeShare(p.y(), 0.06f, footprint)) * (1 - StripeShare(along, 0.04f, 0.6f * footprint));
  return Mix(fill, Rgb(0.03f, 0.03f, 0.035f), lines);
}

struct Window {
  Vector2f low, high;
  std::uint32_t seed;
};

Rgb DrawWindow(const Rgb& behind, const Window& window, const Vector2f& p, float footprint) {
  const float inside = InRectangle(p, window.low, window.high, footprint);
  if (inside <= 0) return behind;
  const Vector2f bar(window.low.x(), window.high.y() - 0.1f), margin(0.1f, 0.1f);
  const Vector2f text_high(window.high.x() - 0.1f, window.high.y() - 0.2f);
  Rgb colour =
      Mix(Rgb(0.85f, 0.86f, 0.87f), Rgb(0.2f, 0.24f, 0.3f), InRectangle(p, bar, window.high, footprint));
  const float ink = Ink(p / 0.075f, footprint / 0.075f, window.seed);
  colour *= 1 - 0.8f * ink * InRectangle(p, window.low + margin, text_high, footprint);
  return Mix(behind, colour, inside);
}

}  // namespace

Rgb PrintTexture(const Paint& paint, const TexturePoint& at) {
  return Mix(paint.colour, paint.second, Ink(at.flat / paint.scale, at.footprint / paint.scale, paint.seed));
}

Rgb PictureTexture(const Paint& paint, const TexturePoint& at) {
  const Vector2f p = at.flat / paint.scale;
  const float footprint = at.footprint / paint.scale;
  const float brush = FadedNoise(at.solid, Eigen::Vector3f(0.02f, 0.006f, 1), at.footprint, paint.seed) +
                      FadedNoise(at.solid, Eigen::Vector3f(0.05f, 0.05f, 1), at.footprint, paint.seed + 1);
  const Rgb colour = paint.seed % 3 == 0   ? Landscape(paint, p, footprint)
                     : paint.seed % 3 == 1 ? Discs(paint, p, footprint)
                                           : Rectangles(paint, p, footprint);
  return colour * (1 + 0.08f * brush);
}

Rgb ScreenTexture(const Paint& paint, const TexturePoint& at) {
  const Vector2f p = at.flat / paint.scale;
  const float footprint = at.footprint / paint.scale;
  const Rgb desktop =
      Mix(paint.colour, paint.second, std::clamp(0.5f + 0.4f * p.y() + 0.1f * p.x(), 0.0f, 1.0f));
  const Rgb with_one = DrawWindow(desktop, {{-1.35f, -0.7f}, {0.1f, 0.6f}, paint.seed}, p, footprint);
  return DrawWindow(with_one, {{-0.25f, -0.5f}, {1.2f, 0.75f}, paint.seed + 1}, p, footprint);
}

Rgb KeyboardTexture(const Paint& paint, const TexturePoint& at) {
  const float footprint = at.footprint / paint.scale;
  const float row = at.flat.y() / paint.scale;
  const float along = at.flat.x() / paint.scale + 0.3f * static_cast<float>(Floor(row));
  const float gap = 1 - (1 - StripeShare(row, 0.16f, footprint)) * (1 - StripeShare(along, 0.16f, footprint));
  const float letter = Fade(footprint, 0.5f) * StripeShare(row + 0.4f, 0.25f, footprint) *
                       StripeShare(along + 0.6f, 0.2f, footprint);
  return Mix(Mix(paint.colour, Rgb(0.6f, 0.6f, 0.6f), 0.6f * letter), paint.second, gap);
}

}  // namespace armature
