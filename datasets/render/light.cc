// SPDX-License-Identifier: BSD-3-Clause
// Direct light: rays from each point to places spread over each lamp. Reflected light: rays over the
// hemisphere above each point, which bring what the surfaces that they meet reflect; this twice, the first
// time with few rays, so that light of several reflections is there.
#include "datasets/render/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/interrupt.h"
#include "datasets/render/texture_functions.h"
#include "drawing/noise.h"
#include "drawing/sampling.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kLift = 1e-3;         // metres that points are above their surface
constexpr float kMeanRadiance = 0.3f;  // of a well exposed picture
constexpr float kWhiteBalance = 0.8f;  // how much of the light's colour a camera takes away

using Grids = std::vector<LightGrid>;  // one a quad

struct GridRow {
  size_t quad = 0;
  int row = 0;
};

struct GridPoint {
  Vector3d position;  // a little above the surface
  Vector3d normal;
  std::uint32_t hash = 0;  // another one for each point
};

class LightComputation {
 public:
  LightComputation(const RayScene& rays, const Surfaces& surfaces, const RenderOptions& options)
      : rays_(rays), surfaces_(surfaces) {
    for (size_t q = 0; q < surfaces.quads.size(); ++q) {
      direct_.emplace_back(surfaces.quads[q], options.light_grid);
      for (int row = 0; row < direct_.back().rows; ++row) grid_rows_.push_back({q, row});
    }
  }

  Light Compute(Lamps lamps, int samples) {
    ForAllPoints(&direct_, [&](const GridPoint& at, const Rgb&, char*) {
      return lamps.LightAt(rays_, at.position, at.normal, at.hash);
    });
    reflected_ = direct_;
    const Rgb guess = GuessReflected();
    for (LightGrid& grid : reflected_) std::ranges::fill(grid.light, guess);
    GatherReflected(samples / 4);
    for (size_t q = 0; q < direct_.size(); ++q) {
      direct_[q].hidden = reflected_[q].hidden;
      direct_[q].FillHidden();
      direct_[q].Smooth();
    }
    GatherReflected(samples);
    for (size_t q = 0; q < direct_.size(); ++q) direct_[q].Add(reflected_[q]);
    return Exposed(std::move(lamps));
  }

 private:
  // light_at(point, light so far, whether it is hidden) -> light.
  template <typename LightAt>
  void ForAllPoints(Grids* grids, const LightAt& light_at) const {
#pragma omp parallel for schedule(dynamic, 16)
    for (size_t i = 0; i < grid_rows_.size(); ++i) {
      if (InterruptSignal() != 0) continue;
      const auto [q, row] = grid_rows_[i];
      const SurfaceQuad& quad = surfaces_.quads[q];
      LightGrid& grid = (*grids)[q];
      for (int column = 0; column < grid.columns; ++column) {
        const GridPoint at{MakePoint(grid, quad, column, row) + kLift * quad.normal, quad.normal,
                           Hash(static_cast<int>(q), column, row, 0)};
        const size_t index = grid.Index(column, row);
        grid.light[index] = light_at(at, grid.light[index], &grid.hidden[index]);
      }
    }
    ThrowIfInterrupted();
  }

  // What is reflected on average, over all reflections: a geometric series.
  Rgb GuessReflected() const {
    Rgb reflected(0, 0, 0), colour(0, 0, 0);
    float area = 1e-9f;
    for (size_t q = 0; q < direct_.size(); ++q) {
      const auto quad_area = static_cast<float>(surfaces_.quads[q].Area());
      const Rgb& paint = MeanColour(q);
      Rgb sum(0, 0, 0);
      for (const Rgb& light : direct_[q].light) sum += light;
      reflected += quad_area * paint * sum / static_cast<float>(direct_[q].light.size());
      colour += quad_area * paint;
      area += quad_area;
    }
    return reflected / area / (1 - (colour / area).min(0.8f));
  }

  void GatherReflected(int samples) {
    const std::vector<Eigen::Vector2d> places = SpreadPlaces(std::max(8, samples));
    Grids gathered = reflected_;
    ForAllPoints(&gathered, [&](const GridPoint& at, const Rgb& before, char* hidden) {
      const bool sees_nothing = *hidden != 0 || before.maxCoeff() <= 0;  // as the outer sides of walls
      return sees_nothing ? before : Gather(at, places, hidden);
    });
    for (LightGrid& grid : gathered) {
      grid.FillHidden();
      grid.Smooth();
      grid.Smooth();
    }
    reflected_ = std::move(gathered);
  }

  // Where most rays meet backs the point is inside of something.
  Rgb Gather(const GridPoint& at, const std::vector<Eigen::Vector2d>& places, char* hidden) const {
    const Eigen::Matrix3d axes = AxesAround(at.normal);
    const PlaceShift shifted(at.hash);
    std::vector<Vector3d> directions(places.size());
    for (size_t i = 0; i < places.size(); ++i) {
      directions[i] = HemisphereDirection(shifted(places[i]), axes);
    }
    std::vector<RayHit> hits(places.size());
    rays_.Nearest(at.position, directions, hits);
    Rgb sum(0, 0, 0);
    size_t backs = 0;
    for (size_t i = 0; i < hits.size(); ++i) {
      if (hits[i].mesh < 0) continue;
      const auto q = static_cast<size_t>(surfaces_.GetQuad(hits[i]));
      const bool is_back = surfaces_.quads[q].normal.dot(directions[i]) > 0;
      backs += is_back ? 1 : 0;
      if (is_back) continue;
      sum += MeanColour(q) * (direct_[q].At(hits[i].u, hits[i].v) + reflected_[q].At(hits[i].u, hits[i].v));
    }
    *hidden = 2 * backs > hits.size();
    return sum / static_cast<float>(hits.size());
  }

  // What a camera multiplies colours with, given the mean light on surfaces and the mean that they reflect.
  static Rgb Gain(const Rgb& light, const Rgb& reflected) {
    if (light.minCoeff() <= 0 || reflected.minCoeff() <= 0) return Rgb(1, 1, 1);
    const Rgb white = (light.mean() / light).pow(kWhiteBalance);
    return white * (kMeanRadiance / (white * reflected).mean());
  }

  Light Exposed(Lamps lamps) {
    Rgb light_sum(0, 0, 0), reflected_sum(0, 0, 0);
    float area = 1e-9f;
    for (size_t q = 0; q < direct_.size(); ++q) {
      const LightGrid& grid = direct_[q];
      const double quad_area = surfaces_.quads[q].Area();
      const auto point_area = static_cast<float>(quad_area / static_cast<double>(grid.light.size()));
      for (size_t i = 0; i < grid.light.size(); ++i) {
        if (grid.hidden[i] != 0 || grid.light[i].maxCoeff() <= 0) continue;
        light_sum += point_area * grid.light[i];
        reflected_sum += point_area * MeanColour(q) * grid.light[i];
        area += point_area;
      }
    }
    const Rgb gain = Gain(light_sum / area, reflected_sum / area);
    for (LightGrid& grid : direct_) grid.Multiply(gain);
    lamps.Multiply(gain);
    return {std::move(direct_), std::move(lamps), gain * reflected_sum / area};
  }

  const Rgb& MeanColour(size_t quad) const { return surfaces_.GetPart(surfaces_.quads[quad]).paint.mean; }

  const RayScene& rays_;
  const Surfaces& surfaces_;
  std::vector<GridRow> grid_rows_;
  Grids direct_, reflected_;
};

}  // namespace

Light ComputeLight(const RayScene& rays, const Surfaces& surfaces, const std::vector<Lamp>& lamps,
                   const RenderOptions& options) {
  const int samples = options.light_samples;
  return LightComputation(rays, surfaces, options)
      .Compute(Lamps(lamps, std::max(8, samples * 3 / 8)), samples);
}

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
