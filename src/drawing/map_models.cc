// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/map_models.h"

#include "geometry/mesh_shapes.h"

namespace armature {
namespace {

using Eigen::Vector3d;

// Metres.
constexpr double kBallRadius = 0.045, kBallSpacing = 0.4;
constexpr double kDotRadius = 0.014, kDotSpacing = 0.07;
constexpr double kWireframeThickness = 0.014;

Colour MakeColour(const ColourBytes& bytes) { return bytes.cast<double>() / 255; }

PlacedMesh MakeBody(const TriangleMesh& mesh, const ColourBytes& colour,
                    const Eigen::Isometry3d& T_world_mesh) {
  Part part;
  part.material.colour = MakeColour(colour);
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Vector3d c = mesh.vertices.col(triangle[2]);
    part.quads.push_back({{Vector3d(mesh.vertices.col(triangle[0])), mesh.vertices.col(triangle[1]), c, c}});
  }
  return {{{part}}, T_world_mesh};
}

PlacedMesh GroundBody(const MapGround& ground) {
  const Eigen::Vector2d low = ground.area.min(), high = ground.area.max();
  Part part;
  part.quads.push_back({{Vector3d(low.x(), low.y(), 0),
                         {high.x(), low.y(), 0},
                         {high.x(), high.y(), 0},
                         {low.x(), high.y(), 0}}});
  return {{{part}}, ground.T_world_ground};
}

}  // namespace

std::vector<Vector3d> PathDots(const std::vector<Eigen::Isometry3d>& T_world_camera, double spacing) {
  std::vector<Vector3d> dots;
  double next = 0;  // how far along the leg the next dot is
  for (size_t i = 1; i < T_world_camera.size(); ++i) {
    const Vector3d from = T_world_camera[i - 1].translation(), leg = T_world_camera[i].translation() - from;
    const double length = leg.norm();
    for (; next < length; next += spacing) dots.push_back(from + next / length * leg);
    next -= length;
  }
  return dots;
}

std::vector<PlacedMesh> MapBodies(const MapScene& scene, const MapGround& ground) {
  std::vector<PlacedMesh> bodies{GroundBody(ground)};
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const MapSceneObject& object = scene.objects[i];
    bodies.push_back(MakeBody(object.cad, ObjectColour(scene, i), object.T_world_object));
  }
  return bodies;
}

std::vector<PlacedMesh> MapPath(const MapScene& scene) {
  TriangleMesh balls, dots;
  for (const Eigen::Isometry3d& camera : SpacedCameras(scene.T_world_camera, kBallSpacing)) {
    Append(BallMesh(camera.translation(), kBallRadius), kCameraColour, balls);
  }
  for (const Vector3d& dot : PathDots(scene.T_world_camera, kDotSpacing)) {
    Append(BallMesh(dot, kDotRadius), kPathColour, dots);
  }
  const Eigen::Isometry3d in_world = Eigen::Isometry3d::Identity();
  return {MakeBody(balls, kCameraColour, in_world), MakeBody(dots, kPathColour, in_world)};
}

std::vector<PlacedMesh> MapWireframes(const MapScene& scene) {
  std::vector<PlacedMesh> wireframes;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const MapSceneObject& object = scene.objects[i];
    const ColourBytes colour = WireframeColour(scene, i);
    wireframes.push_back(MakeBody(WireframeMesh(object.wireframe, kWireframeThickness, colour), colour,
                                  object.T_world_object));
  }
  return wireframes;
}

}  // namespace armature
