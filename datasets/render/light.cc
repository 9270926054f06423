// SPDX-License-Identifier: BSD-3-Clause
// Direct light: rays from each point to places spread over each lamp. Reflected light: rays over the
// hemisphere above each point, which bring what the surfaces that they meet reflect; this twice, the first
// time with few rays, so that light of several reflections is there.
#include "datasets/render/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/render/noise.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLift = 1e-3;          // metres that points are above their surface
constexpr double kHiddenShare = 0.5;    // of rays that meet backs: the point is inside of something
constexpr float kMeanRadiance = 0.28f;  // of a well exposed picture

// Evenly over the unit square (Hammersley's points), shifted for each point so that errors of neighbours do
// not add up to bands.
std::vector<Vector2d> Spread(int count, std::uint32_t hash) {
  const double shift_x = Unit(Mixed(hash)), shift_y = Unit(Mixed(hash + 1));
  std::vector<Vector2d> places;
  for (int i = 0; i < count; ++i) {
    double inverse = 0;
    for (int bits = i, k = 1; bits > 0; bits >>= 1, ++k) inverse += (bits & 1) * std::ldexp(1.0, -k);
    const double x = (i + 0.5) / count + shift_x, y = inverse + shift_y;
    places.emplace_back(x - std::floor(x), y - std::floor(y));
  }
  return places;
}

// More likely where the cosine to the normal is greater, so that all count the same.
Vector3d HemisphereDirection(const Vector2d& place, const Eigen::Matrix3d& axes) {
  const double angle = 2 * std::numbers::pi * place.x(), radius = std::sqrt(place.y());
  return axes * Vector3d(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - place.y()));
}

Eigen::Matrix3d AxesAround(const Vector3d& normal) {
  Eigen::Matrix3d axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

struct GridRow {
  size_t quad = 0;
  int row = 0;
};

class LightComputation {
 public:
  LightComputation(const RayScene& rays, const Surfaces& surfaces, const std::vector<Lamp>& lamps,
                   const RenderOptions& options)
      : rays_(rays), surfaces_(surfaces), lamps_(lamps), options_(options) {
    for (size_t q = 0; q < surfaces.quads.size(); ++q) {
      direct_.emplace_back(surfaces.quads[q], options.light_grid);
      for (int row = 0; row < direct_.back().rows; ++row) grid_rows_.push_back({q, row});
    }
    reflected_ = direct_;
  }

  Light Compute() {
    ForAllPoints(&direct_, [&](const SurfaceQuad& quad, const Vector3d& point, std::uint32_t hash, char*) {
      return Direct(quad, point, hash);
    });
    const Rgb guess = GuessReflected();
    for (LightGrid& grid : reflected_) std::ranges::fill(grid.light, guess);
    GatherReflected(options_.light_samples / 4);
    for (size_t q = 0; q < direct_.size(); ++q) {
      direct_[q].hidden = reflected_[q].hidden;
      direct_[q].FillHidden();
      direct_[q].Smooth();
    }
    GatherReflected(options_.light_samples);
    return Exposed();
  }

 private:
  template <typename LightAt>
  void ForAllPoints(std::vector<LightGrid>* grids, const LightAt& light_at) const {
#pragma omp parallel for schedule(dynamic, 16)
    for (size_t i = 0; i < grid_rows_.size(); ++i) {
      const auto [q, row] = grid_rows_[i];
      const SurfaceQuad& quad = surfaces_.quads[q];
      LightGrid& grid = (*grids)[q];
      for (int column = 0; column < grid.columns; ++column) {
        const Vector3d point = PointOf(grid, quad, column, row) + kLift * quad.normal;
        const size_t index = grid.Index(column, row);
        grid.light[index] =
            light_at(quad, point, Hash(static_cast<int>(q), column, row, 0), &grid.hidden[index]);
      }
    }
  }

  Rgb Direct(const SurfaceQuad& quad, const Vector3d& point, std::uint32_t hash) const {
    Rgb sum(0, 0, 0);
    for (const Lamp& lamp : lamps_) {
      const float received = Received(lamp, quad, point, hash = Mixed(hash + 7));
      sum += received * static_cast<float>(lamp.power) * LinearColour(lamp.colour);
    }
    return sum;
  }

  // Of a lamp of radiance 1.
  float Received(const Lamp& lamp, const SurfaceQuad& quad, const Vector3d& point, std::uint32_t hash) const {
    if (lamp.centre.z() <= point.z()) return 0;
    std::vector<Vector3d> places;
    std::vector<double> weights;
    for (const Vector2d& place : Spread(std::max(8, options_.light_samples / 2), hash)) {
      const Vector2d shift = (place - Vector2d(0.5, 0.5)).cwiseProduct(lamp.size);
      places.emplace_back(lamp.centre + Vector3d(shift.x(), shift.y(), 0));
      const Vector3d to_lamp = places.back() - point;
      const double cosines = std::max(0.0, quad.normal.dot(to_lamp)) * to_lamp.z();
      weights.push_back(cosines / (to_lamp.squaredNorm() * to_lamp.squaredNorm()));
    }
    if (*std::ranges::max_element(weights) <= 0) return 0;
    std::vector<char> blocked(places.size());
    rays_.AreBlocked(point, places, blocked);
    double sum = 0;
    for (size_t i = 0; i < weights.size(); ++i) sum += blocked[i] ? 0 : weights[i];
    return static_cast<float>(sum / static_cast<double>(weights.size()) * lamp.size.prod() /
                              std::numbers::pi);
  }

  // What is reflected on average, over all reflections.
  Rgb GuessReflected() const {
    Rgb reflected(0, 0, 0), colour(0, 0, 0);
    float area = 0;
    for (size_t q = 0; q < direct_.size(); ++q) {
      const SurfaceQuad& quad = surfaces_.quads[q];
      const Rgb& paint = surfaces_.PartOf(quad).paint.mean;
      const auto quad_area = static_cast<float>(quad.Area());
      Rgb sum(0, 0, 0);
      for (const Rgb& light : direct_[q].light) sum += light;
      reflected += quad_area * paint * sum / static_cast<float>(direct_[q].light.size());
      colour += quad_area * paint;
      area += quad_area;
    }
    return reflected / (area * (1 - (colour / area).min(0.8f)));
  }

  void GatherReflected(int samples) {
    std::vector<LightGrid> gathered = reflected_;
    ForAllPoints(&gathered, [&](const SurfaceQuad& quad, const Vector3d& point, std::uint32_t hash,
                                char* hidden) { return Gather(quad, point, samples, hash, hidden); });
    for (LightGrid& grid : gathered) {
      grid.FillHidden();
      grid.Smooth();
      grid.Smooth();
    }
    reflected_ = std::move(gathered);
  }

  Rgb Gather(const SurfaceQuad& quad, const Vector3d& point, int samples, std::uint32_t hash,
             char* hidden) const {
    const Eigen::Matrix3d axes = AxesAround(quad.normal);
    std::vector<Vector3d> directions;
    for (const Vector2d& place : Spread(std::max(8, samples), hash)) {
      directions.push_back(HemisphereDirection(place, axes));
    }
    std::vector<RayHit> hits(directions.size());
    rays_.Nearest(point, directions, hits);
    Rgb sum(0, 0, 0);
    size_t backs = 0;
    for (size_t i = 0; i < hits.size(); ++i) {
      if (hits[i].mesh < 0) continue;
      const auto met = static_cast<size_t>(surfaces_.QuadOf(hits[i]));
      if (surfaces_.quads[met].normal.dot(directions[i]) > 0) {
        ++backs;
      } else {
        sum += Reflected(met, hits[i]);
      }
    }
    *hidden = static_cast<double>(backs) > kHiddenShare * static_cast<double>(hits.size());
    return sum / static_cast<float>(hits.size());
  }

  Rgb Reflected(size_t quad, const RayHit& hit) const {
    const Paint& paint = surfaces_.PartOf(surfaces_.quads[quad]).paint;
    return paint.mean * (direct_[quad].At(hit.u, hit.v) + reflected_[quad].At(hit.u, hit.v));
  }

  Light Exposed() {
    Light light;
    Rgb sum(0, 0, 0);
    double area = 0;
    for (size_t q = 0; q < direct_.size(); ++q) {
      LightGrid& grid = direct_[q];
      const SurfaceQuad& quad = surfaces_.quads[q];
      const double point_area = quad.Area() / static_cast<double>(grid.light.size());
      for (size_t i = 0; i < grid.light.size(); ++i) {
        grid.light[i] += reflected_[q].light[i];
        if (grid.hidden[i]) continue;
        sum += static_cast<float>(point_area) * surfaces_.PartOf(quad).paint.mean * grid.light[i];
        area += point_area;
      }
    }
    const float mean = sum.mean() / static_cast<float>(std::max(area, 1e-9));
    const float exposure = mean > 0 ? kMeanRadiance / mean : 1;
    for (LightGrid& grid : direct_) {
      for (Rgb& value : grid.light) value *= exposure;
    }
    for (const Lamp& lamp : lamps_) {
      light.lamps.push_back(exposure * static_cast<float>(lamp.power) * LinearColour(lamp.colour));
    }
    light.mean = exposure * sum / static_cast<float>(std::max(area, 1e-9));
    light.grids = std::move(direct_);
    return light;
  }

  const RayScene& rays_;
  const Surfaces& surfaces_;
  const std::vector<Lamp>& lamps_;
  const RenderOptions& options_;
  std::vector<GridRow> grid_rows_;
  std::vector<LightGrid> direct_, reflected_;
};

}  // namespace

Light ComputeLight(const RayScene& rays, const Surfaces& surfaces, const std::vector<Lamp>& lamps,
                   const RenderOptions& options) {
  return LightComputation(rays, surfaces, lamps, options).Compute();
}

}  // namespace armature
