// SPDX-License-Identifier: BSD-3-Clause
// The colour of a material at a point. Detail that is finer than what a pixel covers fades to its mean, as
// in a photograph; drawn point by point it would flicker.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "drawing/mesh.h"

namespace armature {

using Rgb = Eigen::Array3f;  // linear: proportional to light

Rgb LinearColour(const Colour& colour);

// A material made ready.
struct Paint {
  Texture texture = Texture::kPlain;
  Rgb colour{0, 0, 0}, second{0, 0, 0};
  float scale = 0.1f;  // metres
  float gloss = 0;
  std::uint32_t seed = 0;
  Rgb mean{0, 0, 0};  // over many places

  explicit Paint(const Material& material);
};

// `point` and the surface's unit `normal` are in the part's frame; `footprint`: metres that a pixel covers
// there. Materials that are drawn in the x-y plane are plain on surfaces that stand upright on it.
Rgb ColourAt(const Paint& paint, const Eigen::Vector3f& point, const Eigen::Vector3f& normal,
             float footprint);

}  // namespace armature
