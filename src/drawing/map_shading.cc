// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/map_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "drawing/sampling.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Colour kGroundColour(0.93, 0.93, 0.92), kLineColour(0.80, 0.81, 0.82);
constexpr double kLineWidth = 0.014;  // metres, of the grid
constexpr double kSky = 0.62, kLamp = 0.5;
constexpr double kHiddenSky = 0.25;   // that shines through what hides it: light from elsewhere
constexpr double kLampRadius = 0.12;  // at a distance of 1
constexpr double kSkyReach = 0.7;     // metres; what is further away hides nothing of the sky
constexpr double kFar = 30;           // metres, to the lamp
constexpr double kShadowLift = 2e-3;  // metres that rays start above their surface
constexpr size_t kLampRays = 16;      // as many to the sky; whole packets (ray_scene.h)
const Vector3d kToLamp = Vector3d(-0.45, -0.35, 1).normalized();  // ground frame

bool IsOnGridLine(double from_side) { return std::abs(from_side - std::round(from_side)) < kLineWidth / 2; }

const PlacedMesh& GetMesh(const RayScene& rays, const RayHit& hit) {
  return rays.meshes()[static_cast<size_t>(hit.mesh)];
}

const Part& GetPart(const RayScene& rays, const RayHit& hit) {
  return GetMesh(rays, hit).mesh.parts[static_cast<size_t>(hit.part)];
}

// 1: lit by all of the lamp, or sees all of the sky.
double OpenShare(std::span<const char> blocked) {
  const auto open = std::count(blocked.begin(), blocked.end(), 0);
  return static_cast<double>(open) / static_cast<double>(blocked.size());
}

}  // namespace

Colour MaterialColour(const RayScene& rays, const RayHit& hit) {
  return DecodeColour(GetPart(rays, hit).material.colour);
}

Vector3d FacingNormal(const RayScene& rays, const RayHit& hit, const Vector3d& direction) {
  const auto& corners = GetPart(rays, hit).quads[static_cast<size_t>(hit.quad)].corners;
  const Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const Vector3d normal = GetMesh(rays, hit).T_world_mesh.linear() * across.normalized();
  return normal.dot(direction) > 0 ? Vector3d(-normal) : normal;
}

MapShading::MapShading(std::vector<PlacedMesh> bodies, const MapGround& ground)
    : rays_(std::move(bodies)),
      ground_(ground),
      to_lamp_world_(ground.T_world_ground.linear() * kToLamp),
      places_(SpreadPlaces(static_cast<int>(kLampRays))) {}

Colour MapShading::ColourAt(const RayHit& hit, const Vector3d& point) const {
  if (hit.mesh > 0) return MaterialColour(rays_, hit);
  const Vector2d from_corner = (ground_.T_world_ground.inverse() * point).head<2>() - ground_.area.min();
  const bool is_line = IsOnGridLine(from_corner.x()) || IsOnGridLine(from_corner.y());
  return DecodeColour(is_line ? kLineColour : kGroundColour);
}

double MapShading::LightAt(const Vector3d& point, const Vector3d& normal, std::uint32_t hash) const {
  const PlaceShift shift(hash);
  const Vector3d start = point + kShadowLift * normal;
  const Eigen::Matrix3d sky = AxesAround(normal), lamp = AxesAround(to_lamp_world_);
  std::array<Vector3d, 2 * kLampRays> ends;
  for (size_t i = 0; i < kLampRays; ++i) {
    const Vector2d place = shift(places_[i]);
    const double angle = 2 * std::numbers::pi * place.x(), radius = kLampRadius * std::sqrt(place.y());
    ends[i] = start + kFar * (lamp * Vector3d(radius * std::cos(angle), radius * std::sin(angle), 1));
    ends[kLampRays + i] = start + kSkyReach * HemisphereDirection(place, sky);
  }
  std::array<char, ends.size()> blocked{};
  const double slant = std::max(0.0, normal.dot(to_lamp_world_));
  const size_t first = slant > 0 ? 0 : kLampRays;  // no lamp behind the surface
  rays_.AreBlocked(start, std::span(ends).subspan(first), std::span(blocked).subspan(first));
  const double lit = OpenShare(std::span(blocked).first(kLampRays));
  const double open = OpenShare(std::span(blocked).last(kLampRays));
  return kLamp * slant * lit + kSky * (kHiddenSky + (1 - kHiddenSky) * open);
}

double PixelLight::At(const RayHit& hit, const Vector3d& point, const Vector3d& direction) {
  for (const Known& known : known_) {
    if (known.mesh == hit.mesh && known.quad == hit.quad) return known.light;
  }
  const Vector3d normal = FacingNormal(shading_.rays(), hit, direction);
  return known_.emplace_back(Known{hit.mesh, hit.quad, shading_.LightAt(point, normal, hash_)}).light;
}

}  // namespace armature
