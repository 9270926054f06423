// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace armature {
namespace {

constexpr double kNear = 0.05;  // metres

// The part of a convex polygon (camera frame) beyond the near plane.
std::vector<Eigen::Vector3d> CutAtNearPlane(const std::vector<Eigen::Vector3d>& corners) {
  std::vector<Eigen::Vector3d> kept;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % corners.size()];
    if (a.z() >= kNear) kept.push_back(a);
    if ((a.z() >= kNear) != (b.z() >= kNear)) kept.push_back(a + (b - a) * (kNear - a.z()) / (b.z() - a.z()));
  }
  return kept;
}

// Columns between the left and right side of a convex polygon (pixels) in a row; empty: second < first.
std::pair<int, int> Span(const std::vector<Eigen::Vector2d>& outline, int row, int width) {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if (row < std::min(a.y(), b.y()) || row > std::max(a.y(), b.y()) || a.y() == b.y()) continue;
    const double x = a.x() + (b.x() - a.x()) * (row - a.y()) / (b.y() - a.y());
    left = std::min(left, x);
    right = std::max(right, x);
  }
  if (left > right) return {0, -1};
  return {static_cast<int>(std::ceil(std::max(left, 0.0))),
          static_cast<int>(std::floor(std::min(right, width - 1.0)))};
}

// On a plane n.X = d the inverse depth is n.ray / d: affine in the pixel.
void Draw(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal, int index,
          const Camera& camera, VisibleSurfaces* surfaces) {
  const double d = normal.dot(corners.front());
  if (d > -1e-9) return;  // seen from behind
  std::vector<Eigen::Vector2d> outline;
  for (const Eigen::Vector3d& corner : CutAtNearPlane(corners)) outline.push_back(camera.Project(corner));
  if (outline.size() < 3) return;
  const auto [low, high] = std::minmax_element(outline.begin(), outline.end(),
                                               [](const auto& a, const auto& b) { return a.y() < b.y(); });
  const int first = static_cast<int>(std::ceil(std::max(low->y(), 0.0)));
  const int last = static_cast<int>(std::floor(std::min(high->y(), camera.height - 1.0)));
  for (int row = first; row <= last; ++row) {
    const auto [left, right] = Span(outline, row, camera.width);
    for (int column = left; column <= right; ++column) {
      const double inverse_depth = normal.dot(camera.Ray(Eigen::Vector2d(column, row))) / d;
      if (inverse_depth <= surfaces->inverse_depth(row, column)) continue;
      surfaces->inverse_depth(row, column) = inverse_depth;
      surfaces->polygon(row, column) = index;
    }
  }
}

unsigned char Byte(double value) {
  return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

Camera TwiceAsFine(const Camera& camera) {
  return {2 * camera.width, 2 * camera.height,   2 * camera.fx,
          2 * camera.fy,    2 * camera.cx + 0.5, 2 * camera.cy + 0.5};
}

VisibleSurfaces Rasterize(const std::vector<Polygon>& polygons, const Camera& camera,
                          const Eigen::Isometry3d& T_world_camera) {
  VisibleSurfaces surfaces{cv::Mat1i(camera.height, camera.width, -1),
                           cv::Mat1d(camera.height, camera.width, 0.0)};
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  for (size_t i = 0; i < polygons.size(); ++i) {
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector3d& corner : polygons[i].corners) corners.push_back(T_camera_world * corner);
    Draw(corners, T_camera_world.linear() * polygons[i].normal, static_cast<int>(i), camera, &surfaces);
  }
  return surfaces;
}

cv::Mat3b Shade(const VisibleSurfaces& surfaces, const std::vector<Polygon>& polygons,
                const Camera& fine_camera, const Eigen::Isometry3d& T_world_camera,
                const Lighting& lighting) {
  cv::Mat3b fine(surfaces.polygon.size(), cv::Vec3b(0, 0, 0));
  for (int row = 0; row < fine.rows; ++row) {
    for (int column = 0; column < fine.cols; ++column) {
      const int index = surfaces.polygon(row, column);
      if (index < 0) continue;
      const Polygon& polygon = polygons[static_cast<size_t>(index)];
      const Eigen::Vector3d point =
          T_world_camera * Eigen::Vector3d(fine_camera.Ray(Eigen::Vector2d(column, row)) /
                                           surfaces.inverse_depth(row, column));
      const Colour colour = lighting(polygon, point) * polygon.colour;
      fine(row, column) = cv::Vec3b(Byte(colour.z()), Byte(colour.y()), Byte(colour.x()));
    }
  }
  cv::Mat3b picture;
  cv::resize(fine, picture, cv::Size(fine.cols / 2, fine.rows / 2), 0, 0, cv::INTER_AREA);
  return picture;
}

}  // namespace armature
