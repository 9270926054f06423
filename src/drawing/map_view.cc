// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/map_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kElevation = 41 * kDegree;    // of the viewer above the horizon
constexpr double kFieldOfView = 30 * kDegree;  // horizontal
constexpr double kFrame = 0.04;                // share of the picture that stays free on each side
constexpr double kGroundMargin = 0.3;          // metres around everything
constexpr int kDirections = 36;                // that are tried in half a turn

// What is drawn of the object, world frame; its centre where there is nothing.
Matrix3Xd MakePoints(const MapSceneObject& object) {
  const Eigen::Index cad = object.cad.vertices.cols(), edges = object.wireframe.edges();
  Matrix3Xd points = Matrix3Xd::Zero(3, std::max<Eigen::Index>(1, cad + 2 * edges));
  if (cad > 0) points.leftCols(cad) = object.cad.vertices;
  Eigen::Index next = cad;
  for (int edge = 0; edge < edges; ++edge) {
    for (int end = 0; end < 2; ++end) points.col(next++) = object.wireframe.End(edge, end);
  }
  return object.T_world_object * points;
}

Matrix3Xd MakePoints(const MapScene& scene) {
  std::vector<Vector3d> points;
  for (const Eigen::Isometry3d& pose : scene.T_world_camera) points.push_back(pose.translation());
  for (const MapSceneObject& object : scene.objects) {
    const Matrix3Xd of_object = MakePoints(object);
    for (const auto& point : of_object.colwise()) points.emplace_back(point);
  }
  if (points.empty()) points.emplace_back(0, 0, 0);
  return Eigen::Map<const Matrix3Xd>(points[0].data(), 3, static_cast<Eigen::Index>(points.size()));
}

// The lower quartile of the objects' lowest points: objects on tables end higher, a bad estimate may end
// lower.
double FloorHeight(const MapScene& scene, const Matrix3Xd& points) {
  std::vector<double> lowest;
  for (const MapSceneObject& object : scene.objects) {
    lowest.push_back((scene.up_world.transpose() * MakePoints(object)).minCoeff());
  }
  if (lowest.empty()) return (scene.up_world.transpose() * points).minCoeff();
  const auto quartile = lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 4);
  std::nth_element(lowest.begin(), quartile, lowest.end());
  return *quartile;
}

// Columns: right, away from the viewer, up.
Eigen::Matrix3d GroundAxes(const Vector3d& away, const Vector3d& up) {
  Eigen::Matrix3d axes;
  axes << away.cross(up), away, up;
  return axes;
}

Eigen::Matrix3d ShallowAxes(const MapScene& scene, const Matrix3Xd& points) {
  const Vector3d side = scene.up_world.unitOrthogonal();
  Vector3d shallow = side;
  double least = 1e300;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = std::numbers::pi * i / kDirections;
    const Vector3d away = Eigen::AngleAxisd(angle, scene.up_world) * side;
    const Eigen::RowVectorXd depths = away.transpose() * points;
    const double extent = depths.maxCoeff() - depths.minCoeff();
    if (extent < least) shallow = away;
    least = std::min(least, extent);
  }
  Vector3d looking = Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : scene.T_world_camera) looking += pose.linear().col(2);
  return GroundAxes(shallow.dot(looking) < 0 ? Vector3d(-shallow) : shallow, scene.up_world);
}

MapGround MakeGround(const MapScene& scene, const Matrix3Xd& points) {
  MapGround ground;
  ground.T_world_ground.linear() = ShallowAxes(scene, points);
  ground.T_world_ground.translation() = FloorHeight(scene, points) * scene.up_world;
  const Eigen::Matrix2Xd flat = (ground.T_world_ground.inverse() * points).topRows<2>();
  const Eigen::Vector2d low = flat.rowwise().minCoeff(), high = flat.rowwise().maxCoeff();
  const Eigen::Vector2d size = (high - low).array() + 2 * kGroundMargin;
  const Eigen::Vector2d centre = (low + high) / 2, whole = size.array().ceil();
  ground.area = Eigen::AlignedBox2d(centre - whole / 2, centre + whole / 2);
  return ground;
}

// Where a camera with these axes has to be so that all points (camera axes) are within its picture, as near
// as possible and with the points in the middle. `slopes`: how far the picture reaches to each side at
// depth 1.
Vector3d NearestCentre(const Matrix3Xd& points, const Eigen::Vector2d& slopes) {
  Vector3d centre(0, 0, 1e300);
  Eigen::Vector2d low, high;  // a side's points are within it if x + slope z >= low, x - slope z <= high
  for (int i = 0; i < 2; ++i) {
    low[i] = (points.row(i) + slopes[i] * points.row(2)).minCoeff();
    high[i] = (points.row(i) - slopes[i] * points.row(2)).maxCoeff();
    centre.z() = std::min(centre.z(), (low[i] - high[i]) / (2 * slopes[i]));
  }
  centre.head<2>() = (low + high) / 2;
  return centre;
}

}  // namespace

MapView FrameMap(const MapScene& scene, int width, int height) {
  MapView view;
  const Matrix3Xd points = MakePoints(scene);
  view.ground = MakeGround(scene, points);
  const double focal = width / 2. / std::tan(kFieldOfView / 2);
  view.camera = {width, height, focal, focal, (width - 1) / 2., (height - 1) / 2., {}};
  Eigen::Matrix3d R_ground_camera;
  R_ground_camera.col(0) = Vector3d::UnitX();
  R_ground_camera.col(2) = Vector3d(0, std::cos(kElevation), -std::sin(kElevation));
  R_ground_camera.col(1) = R_ground_camera.col(2).cross(R_ground_camera.col(0));
  view.T_world_camera.linear() = view.ground.T_world_ground.linear() * R_ground_camera;
  Matrix3Xd shown(3, points.cols() + 4);
  shown.leftCols(points.cols()) = points;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d corner = view.ground.area.corner(static_cast<Eigen::AlignedBox2d::CornerType>(i));
    shown.col(points.cols() + i) = view.ground.T_world_ground * Vector3d(corner.x(), corner.y(), 0);
  }
  const Eigen::Vector2d slopes = (0.5 - kFrame) / focal * Eigen::Vector2d(width, height);
  view.T_world_camera.translation() =
      view.T_world_camera.linear() * NearestCentre(view.T_world_camera.linear().transpose() * shown, slopes);
  return view;
}

}  // namespace armature
