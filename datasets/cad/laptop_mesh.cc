// SPDX-License-Identifier: BSD-3-Clause
// The solid laptop behind and below its wireframe.
#include "datasets/cad/laptop.h"
#include "datasets/cad/solids.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kInlay = 0.0006;  // how far keys, touchpad and screen stand out
constexpr double kHingeRadius = 0.004;

// A thin plate on a face: `face` has x to the right, y up and z out of it; centre and size in its plane.
Part Inlay(const Eigen::Isometry3d& face, const Eigen::Vector2d& centre, const Eigen::Vector2d& size,
           const Material& material) {
  Eigen::Isometry3d frame = face;
  frame.translate(Vector3d(centre.x(), centre.y(), 0));
  return Block(frame, {size.x(), size.y(), 2 * kInlay}, material);
}

void AddBase(const LaptopParameters& p, const LaptopMaterials& materials, Mesh& mesh) {
  mesh.parts.push_back(Block(Vector3d(-0.5 * p.width, -p.base_thickness, 0),
                             Vector3d(0.5 * p.width, 0, p.depth), materials.body));
  Eigen::Isometry3d face = Eigen::Isometry3d::Identity();  // of the base, y away from the user
  face.rotate(Eigen::AngleAxisd(-90 * kDegree, Vector3d::UnitX()));
  mesh.parts.push_back(
      Inlay(face, {0, -0.34 * p.depth}, {0.88 * p.width, 0.44 * p.depth}, materials.keyboard));
  mesh.parts.push_back(
      Inlay(face, {0, -0.79 * p.depth}, {0.30 * p.width, 0.30 * p.depth}, materials.touchpad));
  mesh.parts.push_back(Cylinder({-0.36 * p.width, 0, 0}, {0.36 * p.width, 0, 0}, kHingeRadius, kHingeRadius,
                                10, materials.bezel));
}

void AddLid(const LaptopParameters& p, const LaptopMaterials& materials, Mesh& mesh) {
  Eigen::Isometry3d face = Eigen::Isometry3d::Identity();  // of the lid, origin at the hinge
  face.rotate(Eigen::AngleAxisd((90 - p.lid_angle_deg) * kDegree, Vector3d::UnitX()));
  const Eigen::Isometry3d centre = face * Eigen::Translation3d(0, 0.5 * p.lid_height, -0.5 * p.lid_thickness);
  mesh.parts.push_back(Block(centre, {p.width, p.lid_height, p.lid_thickness}, materials.body));
  const double edge = 0.003, lit_height = p.lid_height - 3 * p.bezel;
  mesh.parts.push_back(
      Inlay(face, {0, 0.5 * p.lid_height}, {p.width - 2 * edge, p.lid_height - 2 * edge}, materials.bezel));
  face.translate(Vector3d(0, 0, kInlay));
  mesh.parts.push_back(Inlay(face, {0, 2 * p.bezel + 0.5 * lit_height}, {p.width - 2 * p.bezel, lit_height},
                             materials.screen));
}

}  // namespace

Mesh LaptopMesh(const LaptopParameters& p, const LaptopMaterials& materials) {
  Mesh mesh;
  AddBase(p, materials, mesh);
  AddLid(p, materials, mesh);
  return mesh;
}

}  // namespace armature
