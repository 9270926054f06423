// SPDX-License-Identifier: BSD-3-Clause
// The light of a scene: direct from the lamps, and reflected by surfaces.
#pragma once

#include <vector>

#include "datasets/render/lamps.h"
#include "datasets/render/light_grid.h"
#include "datasets/render/renderer.h"
#include "datasets/render/surfaces.h"

namespace armature {

constexpr float kScreenBrightness = 0.8f;  // radiance of a white pixel of a screen, which lights nothing

struct Light {
  std::vector<LightGrid> grids;  // one a quad
  Lamps lamps;                   // as bright as they are seen
  Rgb mean{0, 0, 0};             // radiance of all surfaces
};

// As bright as an automatic exposure and white balance would make it. The same for any number of threads.
Light ComputeLight(const RayScene& rays, const Surfaces& surfaces, const std::vector<Lamp>& lamps,
                   const RenderOptions& options);

}  // namespace armature
