// SPDX-License-Identifier: BSD-3-Clause
// The light of a scene: direct from the lamps, and reflected by surfaces.
#pragma once

#include <limits>
#include <vector>

#include "datasets/render/light_grid.h"
#include "datasets/render/renderer.h"
#include "datasets/render/surfaces.h"
#include "datasets/render/textures.h"

namespace armature {

class Lamps {
 public:
  // `samples`: rays from a point to each lamp.
  Lamps(const std::vector<Lamp>& lamps, int samples);

  // Radiance of a white, matt surface at a point a little above it. `hash`: another one for each point.
  Rgb LightAt(const RayScene& rays, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
              std::uint32_t hash) const;

  // Radiance of the lamps that are seen along a ray before `distance`. `blur`: metres a metre that the ray
  // widens.
  Rgb SeenAlong(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double distance,
                double blur) const;

  // Makes them brighter.
  void Multiply(const Rgb& gain);

 private:
  float Received(const Lamp& lamp, const RayScene& rays, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& normal, std::uint32_t hash) const;

  std::vector<Lamp> lamps_;
  std::vector<Rgb> radiances_;
  std::vector<Eigen::Vector2d> places_;  // on a lamp of size 1
};

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
