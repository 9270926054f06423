// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/lamps.h"

#include <algorithm>
#include <numbers>

#include "datasets/render/texture_functions.h"
#include "drawing/sampling.h"

namespace armature {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kTolerance = 0.02;  // metres by which a lamp may be inside of a ceiling and yet be seen

}  // namespace

Lamps::Lamps(const std::vector<Lamp>& lamps, int samples) : lamps_(lamps), places_(SpreadPlaces(samples)) {
  for (const Lamp& lamp : lamps) {
    radiances_.emplace_back(static_cast<float>(lamp.power) * LinearColour(lamp.colour));
  }
}

Rgb Lamps::LightAt(const RayScene& rays, const Vector3d& point, const Vector3d& normal,
                   std::uint32_t hash) const {
  Rgb sum(0, 0, 0);
  for (size_t i = 0; i < lamps_.size(); ++i) {
    hash = Mixed(hash + 7);
    sum += Received(lamps_[i], rays, point, normal, hash) * radiances_[i];
  }
  return sum;
}

// Of a lamp of radiance 1: the integral over its area of both cosines / (pi distance^2), where it is seen.
float Lamps::Received(const Lamp& lamp, const RayScene& rays, const Vector3d& point, const Vector3d& normal,
                      std::uint32_t hash) const {
  if (lamp.centre.z() <= point.z()) return 0;
  std::vector<Vector3d> ends(places_.size());
  std::vector<double> weights(places_.size());
  const PlaceShift shifted(hash);
  for (size_t i = 0; i < places_.size(); ++i) {
    const Vector2d shift = (shifted(places_[i]) - Vector2d(0.5, 0.5)).cwiseProduct(lamp.size);
    ends[i] = lamp.centre + Vector3d(shift.x(), shift.y(), 0);
    const Vector3d to_lamp = ends[i] - point;
    const double cosines = std::max(0.0, normal.dot(to_lamp)) * to_lamp.z();  // times the distance^2
    weights[i] = cosines / (to_lamp.squaredNorm() * to_lamp.squaredNorm());
  }
  if (*std::ranges::max_element(weights) <= 0) return 0;
  std::vector<char> blocked(places_.size());
  rays.AreBlocked(point, ends, blocked);
  double sum = 0;
  for (size_t i = 0; i < weights.size(); ++i) sum += blocked[i] ? 0 : weights[i];
  return static_cast<float>(sum / static_cast<double>(weights.size()) * lamp.size.prod() / std::numbers::pi);
}

Rgb Lamps::SeenAlong(const Vector3d& origin, const Vector3d& direction, double distance, double blur) const {
  Rgb sum(0, 0, 0);
  if (direction.z() <= 0) return sum;
  for (size_t i = 0; i < lamps_.size(); ++i) {
    const Lamp& lamp = lamps_[i];
    const double to_lamp = (lamp.centre.z() - origin.z()) / direction.z();
    if (to_lamp <= 0 || to_lamp > distance + kTolerance) continue;
    const Vector2d p = (origin + to_lamp * direction - lamp.centre).head<2>(), half = 0.5 * lamp.size;
    const double width = blur * to_lamp;
    const float inside =
        InRectangle(p.cast<float>(), -half.cast<float>(), half.cast<float>(), static_cast<float>(width));
    const double spread = lamp.size.prod() / (lamp.size.array() + width).prod();
    sum += inside * static_cast<float>(spread) * radiances_[i];
  }
  return sum;
}

void Lamps::Multiply(const Rgb& gain) {
  for (Rgb& radiance : radiances_) radiance *= gain;
}

}  // namespace armature
