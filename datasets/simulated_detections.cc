// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulated_detections.h"

#include <algorithm>

#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr int kLeastPixels = 4 * 600;  // of the fine picture
constexpr double kBoxNoise = 0.01;     // share of the box's size
constexpr double kAzimuthNoise = 8 * kDegree, kElevationNoise = 4 * kDegree, kTiltNoise = 3 * kDegree;
constexpr int kTurnedEach = 17, kMissedEach = 29;

struct Extent {
  int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;  // fine pixels, inclusive
  int pixels = 0;
};

// Of each piece of furniture.
std::vector<Extent> VisibleExtents(const VisibleSurfaces& surfaces, const std::vector<Polygon>& polygons,
                                   size_t pieces) {
  std::vector<Extent> extents(pieces);
  for (int row = 0; row < surfaces.polygon.rows; ++row) {
    for (int column = 0; column < surfaces.polygon.cols; ++column) {
      const int index = surfaces.polygon(row, column);
      const int object = index < 0 ? 0 : polygons[static_cast<size_t>(index)].object;
      if (object == 0) continue;
      Extent& e = extents[static_cast<size_t>(object) - 1];
      e.left = std::min(e.left, column);
      e.right = std::max(e.right, column);
      e.top = std::min(e.top, row);
      e.bottom = std::max(e.bottom, row);
      ++e.pixels;
    }
  }
  return extents;
}

// Sides of fine pixels in the picture's pixels, whose first one's centre is 0.
Box BoxOf(const Extent& e) {
  return {0.5 * e.left - 0.5, 0.5 * e.top - 0.5, 0.5 * (e.right + 1 - e.left), 0.5 * (e.bottom + 1 - e.top)};
}

}  // namespace

Box DetectionSimulator::Noisy(const Box& box, const Camera& camera) {
  const double left = random_.Normal(box.left(), kBoxNoise * box.width);
  const double right = random_.Normal(box.right(), kBoxNoise * box.width);
  const double top = random_.Normal(box.top(), kBoxNoise * box.height);
  const double bottom = random_.Normal(box.bottom(), kBoxNoise * box.height);
  const Box image{-0.5, -0.5, static_cast<double>(camera.width), static_cast<double>(camera.height)};
  return Intersection({left, top, right - left, bottom - top}, image);
}

void DetectionSimulator::AddViewpoint(const Eigen::Matrix3d& R_camera_object, const Camera& camera,
                                      Detection* detection) {
  const Viewpoint truth = ViewpointFromRotation(R_camera_object, camera.Ray(detection->box.center()));
  const double turn = candidates_ % kTurnedEach == 0 ? 180 * kDegree : 0;
  detection->azimuth = WrapAngle(random_.Normal(truth.azimuth + turn, kAzimuthNoise));
  detection->elevation = random_.Normal(truth.elevation, kElevationNoise);
  detection->tilt = random_.Normal(truth.tilt, kTiltNoise);
}

std::vector<GeneratedDetection> DetectionSimulator::Detect(const VisibleSurfaces& surfaces,
                                                           const std::vector<Polygon>& polygons,
                                                           const std::vector<PlacedFurniture>& furniture,
                                                           const Camera& camera,
                                                           const Eigen::Isometry3d& T_world_camera) {
  const std::vector<Extent> extents = VisibleExtents(surfaces, polygons, furniture.size());
  std::vector<GeneratedDetection> detections;
  for (size_t i = 0; i < furniture.size(); ++i) {
    if (extents[i].pixels < kLeastPixels) continue;
    if (++candidates_ % kMissedEach == 0) continue;
    Detection detection;
    detection.category = furniture[i].furniture.category;
    detection.box = Noisy(BoxOf(extents[i]), camera);
    detection.score = random_.Uniform(0.6, 0.99);
    AddViewpoint(T_world_camera.linear().transpose() * furniture[i].T_world_object.linear(), camera,
                 &detection);
    detections.push_back({detection, furniture[i].id});
  }
  return detections;
}

}  // namespace armature
