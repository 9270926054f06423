// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/visible_objects.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace armature {
namespace {

struct Extent {
  int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;  // pixels, inclusive

  // A pixel reaches half a pixel beyond its centre.
  Box AsBox() const { return {left - 0.5, top - 0.5, right - left + 1.0, bottom - top + 1.0}; }
};

std::map<int, Extent> Extents(const cv::Mat1i& objects) {
  std::map<int, Extent> extents;
  for (int row = 0; row < objects.rows; ++row) {
    for (int column = 0; column < objects.cols; ++column) {
      if (objects(row, column) == kRoom) continue;
      Extent& extent = extents[objects(row, column)];
      extent.left = std::min(extent.left, column);
      extent.right = std::max(extent.right, column);
      extent.top = std::min(extent.top, row);
      extent.bottom = std::max(extent.bottom, row);
    }
  }
  return extents;
}

bool IsInside(const Eigen::Vector2d& pixel, const Camera& camera) {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < camera.width - 0.5 &&
         pixel.y() < camera.height - 0.5;
}

double VisibleShare(const RayScene& rays, int object, const Camera& camera,
                    const Eigen::Isometry3d& T_world_camera, const Box& extent) {
  constexpr int kRays = 400;  // in the extent, and about half as many on the object
  const double step = std::max(0.5, std::sqrt(extent.width * extent.height / kRays));
  int all = 0, seen = 0;
  for (double y = extent.top() + 0.5 * step; y < extent.bottom(); y += step) {
    for (double x = extent.left() + 0.5 * step; x < extent.right(); x += step) {
      const Eigen::Vector2d pixel(x, y);
      const Eigen::Vector3d direction = T_world_camera.linear() * camera.Ray(pixel).normalized();
      if (rays.HitNearestOfObject(object, T_world_camera.translation(), direction).mesh < 0) continue;
      ++all;
      if (!IsInside(pixel, camera)) continue;
      if (rays.Nearest(T_world_camera.translation(), direction).object == object) ++seen;
    }
  }
  return all > 0 ? static_cast<double>(seen) / all : 0.0;
}

}  // namespace

Box ProjectedExtent(const std::vector<PlacedMesh>& meshes, int object, const Camera& camera,
                    const Eigen::Isometry3d& T_camera_world, const Box& within) {
  constexpr double kNear = 0.05;  // metres
  Eigen::AlignedBox2d extent;
  for (const PlacedMesh& mesh : meshes) {
    if (mesh.object != object) continue;
    for (const Part& part : mesh.mesh.parts) {
      for (const Quad& quad : part.quads) {
        for (const Eigen::Vector3d& corner : quad.corners) {
          const Eigen::Vector3d point = T_camera_world * (mesh.T_world_mesh * corner);
          if (point.z() < kNear) return within;
          extent.extend(camera.Project(point));
        }
      }
    }
  }
  const Eigen::Vector2d size = extent.sizes();
  return Intersection({extent.min().x(), extent.min().y(), size.x(), size.y()}, within);
}

std::vector<VisibleObject> VisibleObjects(const RayScene& rays, const cv::Mat1i& objects,
                                          const Camera& camera, const Eigen::Isometry3d& T_world_camera) {
  const double width = camera.width, height = camera.height;
  const Box wide{-width - 0.5, -height - 0.5, 3 * width, 3 * height};
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  std::vector<VisibleObject> visible;
  for (const auto& [object, extent] : Extents(objects)) {
    const Box around = ProjectedExtent(rays.meshes(), object, camera, T_camera_world, wide);
    visible.push_back({object, extent.AsBox(), VisibleShare(rays, object, camera, T_world_camera, around)});
  }
  return visible;
}

}  // namespace armature
