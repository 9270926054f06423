// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/interrupt.h"
#include "datasets/render/light.h"
#include "datasets/render/surfaces.h"
#include "datasets/render/texture_functions.h"
#include "drawing/sampling.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kReflectedLift = 1e-3;  // metres that reflected rays start above their surface
constexpr double kFocus = 1.5;  // how fast the mirror image of a matt surface gets blurred, 1 / metres

}  // namespace

struct Renderer::Implementation {
  RayScene rays;
  RenderOptions options;
  Surfaces surfaces;
  Light light;

  static double Reach(const RayHit& hit) {
    return hit.mesh >= 0 ? hit.distance : std::numeric_limits<double>::infinity();
  }

  struct View {
    Vector3d origin;          // of all rays; world
    double footprint_at_one;  // metres that a ray stands for at a distance of one metre
  };

  // What a surface mirrors; the less polished it is, the more this gets lost in the mean of the room.
  Rgb Mirrored(const SurfaceQuad& quad, float gloss, const Vector3d& point, const Vector3d& direction) const {
    const double cosine = std::abs(quad.normal.dot(direction));
    const auto fresnel = static_cast<float>(0.04 + 0.96 * std::pow(1 - cosine, 5));
    const Vector3d mirrored = direction - 2 * quad.normal.dot(direction) * quad.normal;
    const Vector3d origin = point + kReflectedLift * quad.normal;
    const RayHit hit = rays.Nearest(origin, mirrored);
    Rgb seen = light.mean;
    if (hit.mesh >= 0) {
      const auto met = static_cast<size_t>(surfaces.GetQuad(hit));
      const Rgb there = surfaces.GetPart(surfaces.quads[met]).paint.mean * light.grids[met].At(hit.u, hit.v);
      const double sharpness = std::exp(-kFocus * (1 - gloss) * hit.distance);
      seen = Mix(light.mean, there, static_cast<float>(sharpness));
    }
    seen += light.lamps.SeenAlong(origin, mirrored, Reach(hit), 0.3 * (1 - gloss));
    return gloss * fresnel * seen;
  }

  Rgb Surface(const SurfaceQuad& quad, const RayHit& hit, const Vector3d& point, const Vector3d& direction,
              const View& view) const {
    const SurfacePart& part = surfaces.GetPart(quad);
    const double cosine = std::max(0.02, std::abs(quad.normal.dot(direction)));
    const auto footprint = static_cast<float>(view.footprint_at_one * hit.distance / std::sqrt(cosine));
    const Rgb colour =
        ColourAt(part.paint, part.T_part_world * point.cast<float>(), quad.normal_part, footprint);
    if (part.paint.texture == Texture::kScreen) return kScreenBrightness * colour;
    return colour * light.grids[static_cast<size_t>(surfaces.GetQuad(hit))].At(hit.u, hit.v);
  }

  // The mean of a pixel's rays. Reflections are the same for all rays that meet the same part.
  Rgb Pixel(std::span<const Vector3d> directions, std::span<const RayHit> hits, const View& view) const {
    Rgb sum(0, 0, 0), mirrored(0, 0, 0);
    int mirror = -1;
    for (size_t i = 0; i < hits.size(); ++i) {
      const RayHit& hit = hits[i];
      sum += light.lamps.SeenAlong(view.origin, directions[i], Reach(hit), 0);
      if (hit.mesh < 0) continue;
      const SurfaceQuad& quad = surfaces.quads[static_cast<size_t>(surfaces.GetQuad(hit))];
      const Vector3d point = view.origin + hit.distance * directions[i];
      sum += Surface(quad, hit, point, directions[i], view);
      const float gloss = surfaces.GetPart(quad).paint.gloss;
      if (gloss <= 0) continue;
      if (mirror != quad.part) mirrored = Mirrored(quad, gloss, point, directions[i]);
      mirror = quad.part;
      sum += mirrored;
    }
    return sum / static_cast<float>(hits.size());
  }
};

Renderer::Renderer(std::vector<PlacedMesh> meshes, const std::vector<Lamp>& lamps,
                   const RenderOptions& options) {
  Surfaces surfaces = ListSurfaces(meshes);
  RayScene rays(std::move(meshes));
  Light light = ComputeLight(rays, surfaces, lamps, options);
  implementation_ = std::make_unique<Implementation>(
      Implementation{std::move(rays), options, std::move(surfaces), std::move(light)});
}

Renderer::~Renderer() = default;

const RayScene& Renderer::rays() const { return implementation_->rays; }

Picture Renderer::Render(const Camera& camera, const Eigen::Isometry3d& T_world_camera) const {
  const std::vector<Vector2d> places = SpreadPlaces(implementation_->options.samples);
  const size_t samples = places.size();
  const Implementation::View view{T_world_camera.translation(),
                                  1 / (camera.fx * std::sqrt(static_cast<double>(samples)))};
  std::vector<Vector3d> directions(static_cast<size_t>(camera.width) * samples);
  std::vector<RayHit> hits(directions.size());
  Picture picture{cv::Mat3f(camera.height, camera.width), cv::Mat1i(camera.height, camera.width)};
  for (int y = 0; y < camera.height; ++y) {
    ThrowIfInterrupted();
    for (size_t i = 0; i < directions.size(); ++i) {
      const size_t column = i / samples;
      const Vector2d pixel =
          Vector2d(static_cast<double>(column), y) + places[i % samples] - Vector2d(0.5, 0.5);
      directions[i] = (T_world_camera.linear() * camera.Ray(pixel)).normalized();
    }
    implementation_->rays.Nearest(view.origin, directions, hits);
    for (int x = 0; x < camera.width; ++x) {
      const size_t first = static_cast<size_t>(x) * samples;
      const Rgb rgb = implementation_->Pixel(std::span(directions).subspan(first, samples),
                                             std::span(hits).subspan(first, samples), view);
      picture.radiance(y, x) = cv::Vec3f(rgb[2], rgb[1], rgb[0]);
      picture.objects(y, x) = hits[first].object;
    }
  }
  return picture;
}

}  // namespace armature
