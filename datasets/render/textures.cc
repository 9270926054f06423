// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/textures.h"

#include <cmath>

#include "datasets/render/texture_functions.h"

namespace armature {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// The two axes other than the one that the normal is most along.
Vector2f OnSurface(const Vector3f& p, const Vector3f& normal) {
  int up = 0;
  normal.cwiseAbs().maxCoeff(&up);
  if (up == 0) return {p.y(), p.z()};
  return up == 1 ? Vector2f(p.x(), p.z()) : Vector2f(p.x(), p.y());
}

bool IsDrawnInPlane(Texture texture) {
  switch (texture) {
    case Texture::kTiles:
    case Texture::kBoards:
    case Texture::kPrint:
    case Texture::kPicture:
    case Texture::kScreen:
    case Texture::kKeyboard:
      return true;
    default:
      return false;
  }
}

Rgb Draw(const Paint& paint, const TexturePoint& at) {
  switch (paint.texture) {
    case Texture::kPlain:
      return PlainTexture(paint, at);
    case Texture::kWood:
      return WoodTexture(paint, at);
    case Texture::kFabric:
      return FabricTexture(paint, at);
    case Texture::kCarpet:
      return CarpetTexture(paint, at);
    case Texture::kTiles:
      return TilesTexture(paint, at);
    case Texture::kBoards:
      return BoardsTexture(paint, at);
    case Texture::kPrint:
      return PrintTexture(paint, at);
    case Texture::kPicture:
      return PictureTexture(paint, at);
    case Texture::kScreen:
      return ScreenTexture(paint, at);
    case Texture::kKeyboard:
      return KeyboardTexture(paint, at);
  }
  return paint.colour;
}

// Over places spread evenly (the R2 sequence) around the origin of the part's frame: over a single painting
// or screen, but over many boards, as each has a shade of its own.
Rgb AverageOverPlaces(const Paint& paint) {
  constexpr int kPlaces = 400;
  const float size = (paint.texture == Texture::kBoards ? 30 : 4) * std::max(paint.scale, 0.05f);
  Rgb sum(0, 0, 0);
  for (int i = 0; i < kPlaces; ++i) {
    const float a = 0.7548777f * static_cast<float>(i), b = 0.5698403f * static_cast<float>(i);
    const Vector2f flat = size * Vector2f(a - std::floor(a) - 0.5f, b - std::floor(b) - 0.5f);
    sum += Draw(paint, {Vector3f(flat.x(), flat.y(), 0), flat, 0.001f});
  }
  return sum / kPlaces;
}

}  // namespace

Rgb LinearColour(const Colour& colour) {
  return colour.array()
      .unaryExpr([](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); })
      .cast<float>();
}

Paint::Paint(const Material& material)
    : texture(material.texture),
      colour(LinearColour(material.colour)),
      second(LinearColour(material.second)),
      scale(static_cast<float>(material.scale)),
      gloss(static_cast<float>(material.gloss)),
      seed(Mixed(material.seed + 1)) {
  mean = AverageOverPlaces(*this);
}

Rgb ColourAt(const Paint& paint, const Vector3f& point, const Vector3f& normal, float footprint) {
  const TexturePoint at{point, OnSurface(point, normal), footprint};
  if (IsDrawnInPlane(paint.texture) && std::abs(normal.z()) < 0.7f) return PlainTexture(paint, at);
  return Draw(paint, at);
}

}  // namespace armature
