// SPDX-License-Identifier: BSD-3-Clause
// The light of a drawn map: a lamp above with a soft shadow, and the sky, which corners see less of.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "datasets/render/map_models.h"

namespace armature {

class MapShading {
 public:
  explicit MapShading(std::vector<PlacedMesh> bodies, const MapGround& ground);

  const RayScene& rays() const { return rays_; }

  // sRGB, 0..1, of what a ray meets; `place`: in the unit square, another one for each ray of a pixel, so
  // that few shadow rays for each are many for the pixel.
  Colour ColourOf(const RayHit& hit, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                  const Eigen::Vector2d& place) const;

 private:
  Colour SurfaceColour(const RayHit& hit, const Eigen::Vector3d& point) const;
  double LightAt(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                 const Eigen::Vector2d& place) const;

  RayScene rays_;
  MapGround ground_;
  Eigen::Vector3d to_lamp_world_;
};

// The surface's normal on the side of the viewer.
Eigen::Vector3d FacingNormal(const RayScene& rays, const RayHit& hit, const Eigen::Vector3d& direction);

}  // namespace armature
