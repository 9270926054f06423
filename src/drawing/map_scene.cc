// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/map_scene.h"

#include <algorithm>
#include <array>
#include <set>

#include "geometry/mesh_shapes.h"

namespace armature {
namespace {

constexpr double kShortestBar = 1e-6;  // metres; of a shorter one no direction is left

void AppendBar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double thickness,
               const ColourBytes& colour, TriangleMesh& mesh) {
  if ((b - a).norm() > kShortestBar) Append(BarMesh(a, b, thickness), colour, mesh);
}

// Four bars from the centre to the corners of the picture, four around it; camera frame.
TriangleMesh CameraMesh(double depth) {
  TriangleMesh mesh;
  const double thickness = 0.06 * depth;
  const Eigen::Vector3d corner(0.66 * depth, 0.5 * depth, depth);
  constexpr std::array<std::array<int, 2>, 4> kSigns{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (size_t i = 0; i < 4; ++i) {
    const auto& [x, y] = kSigns[i];
    const auto& [next_x, next_y] = kSigns[(i + 1) % 4];
    const Eigen::Vector3d here = corner.cwiseProduct(Eigen::Vector3d(x, y, 1));
    const Eigen::Vector3d next = corner.cwiseProduct(Eigen::Vector3d(next_x, next_y, 1));
    AppendBar(Eigen::Vector3d::Zero(), here, thickness, kCameraColour, mesh);
    AppendBar(here, next, thickness, kCameraColour, mesh);
  }
  return mesh;
}

TriangleMesh PathMesh(const std::vector<Eigen::Isometry3d>& T_world_camera, double thickness) {
  TriangleMesh mesh;
  std::vector<Eigen::Isometry3d> poses = SpacedCameras(T_world_camera, thickness);
  if (!poses.empty()) poses.push_back(T_world_camera.back());
  for (size_t i = 1; i < poses.size(); ++i) {
    AppendBar(poses[i - 1].translation(), poses[i].translation(), thickness, kPathColour, mesh);
  }
  return mesh;
}

// Its place among the names of the scene's categories.
size_t CategoryNumber(const MapScene& scene, const std::string& category) {
  std::set<std::string> names;
  for (const MapSceneObject& object : scene.objects) names.insert(object.category);
  return static_cast<size_t>(std::distance(names.begin(), names.find(category)));
}

ColourBytes Scaled(const ColourBytes& colour, double factor) {
  return (factor * colour.cast<double>()).array().min(255).cast<unsigned char>();
}

}  // namespace

ColourBytes ObjectColour(const MapScene& scene, size_t object) {
  static const std::array<ColourBytes, 6> kColours{
      {{74, 134, 200}, {88, 168, 106}, {214, 158, 84}, {150, 118, 196}, {200, 98, 90}, {90, 170, 178}}};
  constexpr std::array<double, 5> kShades{1, 0.84, 1.14, 0.92, 1.06};
  const ColourBytes& colour =
      kColours[CategoryNumber(scene, scene.objects[object].category) % kColours.size()];
  return Scaled(colour, kShades[object % kShades.size()]);
}

ColourBytes WireframeColour(const MapScene& scene, size_t object) {
  return Scaled(ObjectColour(scene, object), 0.35);
}

TriangleMesh WireframeMesh(const Wireframe& wireframe, double thickness, const ColourBytes& colour) {
  TriangleMesh mesh;
  for (int edge = 0; edge < wireframe.edges(); ++edge) {
    AppendBar(wireframe.End(edge, 0), wireframe.End(edge, 1), thickness, colour, mesh);
  }
  return mesh;
}

std::vector<Eigen::Isometry3d> SpacedCameras(const std::vector<Eigen::Isometry3d>& T_world_camera,
                                             double spacing) {
  std::vector<Eigen::Isometry3d> spaced;
  double travelled = spacing;
  for (size_t i = 0; i < T_world_camera.size(); ++i) {
    if (i > 0) travelled += (T_world_camera[i].translation() - T_world_camera[i - 1].translation()).norm();
    if (travelled < spacing) continue;
    spaced.push_back(T_world_camera[i]);
    travelled = 0;
  }
  return spaced;
}

TriangleMesh SceneMesh(const MapScene& scene, const SceneMeshOptions& options) {
  TriangleMesh mesh;
  const TriangleMesh camera = CameraMesh(options.camera_depth);
  for (const Eigen::Isometry3d& pose : SpacedCameras(scene.T_world_camera, options.camera_spacing)) {
    Append(Moved(pose, camera), kCameraColour, mesh);
  }
  Append(PathMesh(scene.T_world_camera, options.path_thickness), kPathColour, mesh);
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const MapSceneObject& object = scene.objects[i];
    const ColourBytes colour = WireframeColour(scene, i);
    Append(Moved(object.T_world_object, WireframeMesh(object.wireframe, options.wireframe_thickness, colour)),
           colour, mesh);
    TriangleMesh cad = Moved(object.T_world_object, object.cad);
    cad.colours.resize(3, 0);  // the category's colour, whatever the model's own
    Append(cad, ObjectColour(scene, i), mesh);
  }
  return mesh;
}

}  // namespace armature
