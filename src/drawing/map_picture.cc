// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/map_picture.h"

#include <cstdint>
#include <vector>

#include "base/interrupt.h"
#include "drawing/map_labels.h"
#include "drawing/map_models.h"
#include "drawing/map_shading.h"
#include "drawing/map_view.h"
#include "drawing/sampling.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHiddenShare = 0.35;  // of a wireframe's colour where a body hides it
constexpr double kOnSurface = 0.03;    // metres that a wireframe may lie below a surface to count as seen
constexpr double kShade = 0.25;        // of a marker's light, where it faces the viewer not at all

// What one ray meets.
struct Sample {
  Vector3d direction;
  RayHit body, path, wireframe;
};

class MapPainter {
 public:
  MapPainter(const MapScene& scene, const MapPictureOptions& options)
      : view_(FrameMap(scene, options.width, options.height)),
        places_(SpreadPlaces(options.samples)),
        shading_(MapBodies(scene, view_.ground), view_.ground),
        path_(MapPath(scene)),
        wireframes_(MapWireframes(scene)) {}

  const MapView& view() const { return view_; }

  void PaintRow(int y, cv::Mat3b* picture) const {
    const std::vector<Sample> samples = MakeSamples(y);
    for (int x = 0; x < view_.camera.width; ++x) {
      PixelLight light(shading_, Hash(x, y, 0, 1));
      Colour sum(0, 0, 0);
      for (size_t i = 0; i < places_.size(); ++i) {
        sum += SampleColour(samples[static_cast<size_t>(x) * places_.size() + i], light);
      }
      const Colour mean = sum * 255 / static_cast<double>(places_.size());
      (*picture)(y, x) =
          cv::Vec3b(cv::saturate_cast<unsigned char>(mean[2]), cv::saturate_cast<unsigned char>(mean[1]),
                    cv::saturate_cast<unsigned char>(mean[0]));
    }
  }

 private:
  std::vector<Sample> MakeSamples(int y) const {
    std::vector<Vector3d> directions;
    for (int x = 0; x < view_.camera.width; ++x) {
      for (const Vector2d& place : places_) {
        const Vector2d pixel = Vector2d(x, y) + place - Vector2d(0.5, 0.5);
        directions.push_back((view_.T_world_camera.linear() * view_.camera.Ray(pixel)).normalized());
      }
    }
    const std::vector<RayHit> bodies = TraceHits(shading_.rays(), directions),
                              path = TraceHits(path_, directions),
                              wireframes = TraceHits(wireframes_, directions);
    std::vector<Sample> samples(directions.size());
    for (size_t i = 0; i < samples.size(); ++i) {
      samples[i] = {directions[i], bodies[i], path[i], wireframes[i]};
    }
    return samples;
  }

  std::vector<RayHit> TraceHits(const RayScene& rays, const std::vector<Vector3d>& directions) const {
    std::vector<RayHit> hits(directions.size());
    rays.Nearest(view_.T_world_camera.translation(), directions, hits);
    return hits;
  }

  Colour SampleColour(const Sample& sample, PixelLight& light) const {
    const bool is_path = sample.path.mesh >= 0 && IsBefore(sample.path, sample.body, 0);
    Colour behind = is_path ? PathColour(sample) : BodyColour(sample, light);
    if (sample.wireframe.mesh < 0) return behind;
    const bool is_seen = IsBefore(sample.wireframe, sample.body, kOnSurface) &&
                         !(is_path && IsBefore(sample.path, sample.wireframe, 0));
    const double share = is_seen ? 1 : kHiddenShare;
    return share * EncodeColour(MaterialColour(wireframes_, sample.wireframe)) + (1 - share) * behind;
  }

  static bool IsBefore(const RayHit& hit, const RayHit& other, double tolerance) {
    return other.mesh < 0 || hit.distance < other.distance + tolerance;
  }

  Colour BodyColour(const Sample& sample, PixelLight& light) const {
    if (sample.body.mesh < 0) return {1, 1, 1};
    const Vector3d point = view_.T_world_camera.translation() + sample.body.distance * sample.direction;
    return EncodeColour(light.At(sample.body, point, sample.direction) *
                        shading_.ColourAt(sample.body, point));
  }

  // Without shadows: those of many dots are but noise.
  Colour PathColour(const Sample& sample) const {
    const double facing = -FacingNormal(path_, sample.path, sample.direction).dot(sample.direction);
    return EncodeColour((kShade + (1 - kShade) * facing) * MaterialColour(path_, sample.path));
  }

  MapView view_;
  std::vector<Vector2d> places_;  // of a pixel's rays
  MapShading shading_;
  RayScene path_, wireframes_;
};

}  // namespace

cv::Mat DrawMap(const MapScene& scene, const MapPictureOptions& options) {
  const MapPainter painter(scene, options);
  cv::Mat3b picture(options.height, options.width);
#pragma omp parallel for schedule(dynamic)
  for (int y = 0; y < options.height; ++y) {
    if (InterruptSignal() == 0) painter.PaintRow(y, &picture);
  }
  ThrowIfInterrupted();
  if (options.labels) DrawMapLabels(scene, painter.view(), &picture);
  return picture;
}

}  // namespace armature
