// SPDX-License-Identifier: BSD-3-Clause
// The light of a drawn map: a lamp above with a soft shadow, and the sky, which corners see less of.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "drawing/map_models.h"

namespace armature {

class MapShading {
 public:
  // `bodies` as MapBodies gives them.
  MapShading(std::vector<PlacedMesh> bodies, const MapGround& ground);

  const RayScene& rays() const { return rays_; }

  // Radiance of a surface without colour, about 1 where nothing shades it. `normal`: unit, on the lit side;
  // `hash`: another one for each point.
  double LightAt(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, std::uint32_t hash) const;

  // Of the surface that a ray of this scene meets at the point; linear.
  Colour ColourAt(const RayHit& hit, const Eigen::Vector3d& point) const;

 private:
  RayScene rays_;
  MapGround ground_;
  Eigen::Vector3d to_lamp_world_;
  std::vector<Eigen::Vector2d> places_;  // of the rays to lamp and sky, in the unit square
};

// One pixel: its light is looked for once a surface, for it costs the most.
class PixelLight {
 public:
  // Keeps a reference. `hash`: another one for each pixel.
  PixelLight(const MapShading& shading, std::uint32_t hash) : shading_(shading), hash_(hash) {}

  // Of the surface that a ray along the direction meets at the point; see MapShading::LightAt.
  double At(const RayHit& hit, const Eigen::Vector3d& point, const Eigen::Vector3d& direction);

 private:
  struct Known {
    int mesh, quad;
    double light;
  };

  const MapShading& shading_;
  std::uint32_t hash_;
  std::vector<Known> known_;
};

// Linear, of the material that a ray meets.
Colour MaterialColour(const RayScene& rays, const RayHit& hit);

// The surface's normal on the side that the direction comes from; world frame.
Eigen::Vector3d FacingNormal(const RayScene& rays, const RayHit& hit, const Eigen::Vector3d& direction);

// Between colours as they are picked and proportional to light, close enough to sRGB for a drawing.
inline Colour DecodeColour(const Colour& colour) { return colour.cwiseAbs2(); }
inline Colour EncodeColour(const Colour& linear) { return linear.cwiseMin(1).cwiseSqrt(); }

}  // namespace armature
