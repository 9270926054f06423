// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/render/map_picture.h"

#include <cmath>
#include <vector>

#include "datasets/render/map_labels.h"
#include "datasets/render/map_models.h"
#include "datasets/render/map_shading.h"
#include "datasets/render/map_view.h"
#include "datasets/render/sampling.h"

namespace armature {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHiddenShare = 0.35;  // of a wireframe's colour where a body hides it
constexpr double kOnSurface = 0.03;    // metres that a wireframe may lie below a surface to count as seen

class MapPainter {
 public:
  MapPainter(const MapScene& scene, const MapPictureOptions& options)
      : view_(ViewOfMap(scene, options.width, options.height)),
        places_(SpreadPlaces(options.samples)),
        shading_(MapBodies(scene, view_.ground), view_.ground),
        wireframes_(MapWireframes(scene)) {}

  const MapView& view() const { return view_; }

  void PaintRow(int y, cv::Mat3b* picture) const {
    const size_t samples = places_.size(), rays = static_cast<size_t>(view_.camera.width) * samples;
    std::vector<Vector3d> directions(rays);
    for (size_t i = 0; i < rays; ++i) {
      const Vector2d pixel = Vector2d(static_cast<double>(i / samples), y) + places_[i % samples];
      directions[i] = (view_.T_world_camera.linear() * view_.camera.Ray(pixel.array() - 0.5)).normalized();
    }
    std::vector<RayHit> bodies(rays), wireframes(rays);
    shading_.rays().Nearest(view_.T_world_camera.translation(), directions, bodies);
    wireframes_.Nearest(view_.T_world_camera.translation(), directions, wireframes);
    for (int x = 0; x < view_.camera.width; ++x) {
      const PlaceShift shift(Hash(x, y, 0, 1));
      Colour sum(0, 0, 0);
      for (size_t i = 0; i < samples; ++i) {
        const size_t ray = static_cast<size_t>(x) * samples + i;
        sum += SampleColour(directions[ray], bodies[ray], wireframes[ray], shift(places_[i]));
      }
      sum *= 255 / static_cast<double>(samples);
      for (int channel = 0; channel < 3; ++channel) {
        (*picture)(y, x)[channel] = static_cast<unsigned char>(std::lround(sum[2 - channel]));
      }
    }
  }

 private:
  Colour SampleColour(const Vector3d& direction, const RayHit& body, const RayHit& wireframe,
                      const Vector2d& place) const {
    const Colour behind = shading_.ColourOf(body, view_.T_world_camera.translation(), direction, place);
    if (wireframe.mesh < 0) return behind;
    const Mesh& mesh = wireframes_.meshes()[static_cast<size_t>(wireframe.mesh)].mesh;
    const Colour colour = mesh.parts[0].material.colour;
    const bool is_seen = body.mesh < 0 || wireframe.distance < body.distance + kOnSurface;
    const double share = is_seen ? 1 : kHiddenShare;
    return share * colour + (1 - share) * behind;
  }

  MapView view_;
  std::vector<Vector2d> places_;
  MapShading shading_;
  RayScene wireframes_;
};

}  // namespace

cv::Mat DrawMap(const MapScene& scene, const MapPictureOptions& options) {
  const MapPainter painter(scene, options);
  cv::Mat3b picture(options.height, options.width);
#pragma omp parallel for schedule(dynamic)
  for (int y = 0; y < options.height; ++y) painter.PaintRow(y, &picture);
  if (options.labels) DrawMapLabels(scene, painter.view(), &picture);
  return picture;
}

}  // namespace armature
