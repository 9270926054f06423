// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/map_shading.h"

#include <array>
#include <cmath>
#include <span>

#include "datasets/render/sampling.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Colour kGroundColour(0.93, 0.93, 0.92), kLineColour(0.80, 0.81, 0.82);
constexpr double kLineWidth = 0.014;  // metres, of the grid
constexpr double kSky = 0.62, kLamp = 0.5;
constexpr double kLampRadius = 0.12;  // at a distance of 1
constexpr double kSkyReach = 0.7;     // metres; what is further away hides nothing of the sky
constexpr double kFar = 30;           // metres, to the lamp
constexpr double kLift = 2e-3;        // metres that rays start above their surface
constexpr size_t kSkyRays = 3;
const Vector3d kToLamp = Vector3d(-0.45, -0.35, 1).normalized();  // ground frame

double ToLinear(double value) { return std::pow(value, 2.2); }
double FromLinear(double value) { return std::pow(std::min(1.0, value), 1 / 2.2); }

bool IsOnGridLine(double from_side) { return std::abs(from_side - std::round(from_side)) < kLineWidth / 2; }

}  // namespace

Vector3d FacingNormal(const RayScene& rays, const RayHit& hit, const Vector3d& direction) {
  const PlacedMesh& placed = rays.meshes()[static_cast<size_t>(hit.mesh)];
  const Part& part = placed.mesh.parts[static_cast<size_t>(hit.part)];
  const auto& corners = part.quads[static_cast<size_t>(hit.quad)].corners;
  const Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const Vector3d normal = placed.T_world_mesh.linear() * across.normalized();
  return normal.dot(direction) > 0 ? Vector3d(-normal) : normal;
}

MapShading::MapShading(std::vector<PlacedMesh> bodies, const MapGround& ground)
    : rays_(std::move(bodies)), ground_(ground), to_lamp_world_(ground.T_world_ground.linear() * kToLamp) {}

Colour MapShading::SurfaceColour(const RayHit& hit, const Vector3d& point) const {
  if (hit.mesh > 0) {
    const Mesh& mesh = rays_.meshes()[static_cast<size_t>(hit.mesh)].mesh;
    return mesh.parts[static_cast<size_t>(hit.part)].material.colour;
  }
  const Vector2d from_corner = (ground_.T_world_ground.inverse() * point).head<2>() - ground_.area.min();
  return IsOnGridLine(from_corner.x()) || IsOnGridLine(from_corner.y()) ? kLineColour : kGroundColour;
}

double MapShading::LightAt(const Vector3d& point, const Vector3d& normal, const Vector2d& place) const {
  const Vector3d start = point + kLift * normal;
  const Eigen::Matrix3d sky = AxesAround(normal), lamp = AxesAround(to_lamp_world_);
  std::array<Vector3d, 1 + kSkyRays> ends;
  std::array<char, 1 + kSkyRays> blocked{};
  const double angle = 2 * std::numbers::pi * place.x(), radius = kLampRadius * std::sqrt(place.y());
  ends[0] = start + kFar * (lamp * Vector3d(radius * std::cos(angle), radius * std::sin(angle), 1));
  for (size_t i = 0; i < kSkyRays; ++i) {
    const double turned = place.x() + static_cast<double>(i) / kSkyRays;
    ends[1 + i] = start + kSkyReach * HemisphereDirection({turned, place.y()}, sky);
  }
  rays_.AreBlocked(start, ends, blocked);
  double open = 0;
  for (size_t i = 0; i < kSkyRays; ++i) open += blocked[1 + i] ? 0.25 : 1;
  const double lit = blocked[0] ? 0 : std::max(0.0, normal.dot(to_lamp_world_));
  return kSky * open / kSkyRays + kLamp * lit;
}

Colour MapShading::ColourOf(const RayHit& hit, const Vector3d& origin, const Vector3d& direction,
                            const Vector2d& place) const {
  if (hit.mesh < 0) return {1, 1, 1};
  const Vector3d point = origin + hit.distance * direction;
  const double light = LightAt(point, FacingNormal(rays_, hit, direction), place);
  return SurfaceColour(hit, point).unaryExpr([&](double value) {
    return FromLinear(light * ToLinear(value));
  });
}

}  // namespace armature
