// SPDX-License-Identifier: BSD-3-Clause
// Which laptops there are, their wireframes and their surfaces.
#include "datasets/cad/laptop.h"

#include <algorithm>
#include <cmath>

#include "datasets/cad/edge_ends.h"
#include "datasets/cad/solids.h"
#include "geometry/random.h"
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

// The shipped category model is learnt from these numbers: the solid is drawn from a stream of its own.
LaptopParameters DrawShape(Random& random) {
  LaptopParameters laptop;
  laptop.width = std::clamp(random.Normal(0.34, 0.025), 0.28, 0.40);
  laptop.depth = laptop.width * std::clamp(random.Normal(0.71, 0.06), 0.58, 0.90);
  laptop.lid_height = laptop.depth * random.Normal(0.93, 0.07);
  laptop.lid_angle_deg = std::clamp(random.Normal(106, 12), 90.0, 135.0);
  return laptop;
}

void DrawSolid(Random& random, LaptopParameters& laptop) {
  laptop.base_thickness = random.Uniform(0.011, 0.024);
  laptop.lid_thickness = random.Uniform(0.004, 0.008);
  laptop.bezel = random.Uniform(0.006, 0.018);
}

}  // namespace

Wireframe LaptopWireframe(const LaptopParameters& p) {
  const double x = p.width / 2, angle = p.lid_angle_deg * kDegree;
  const double top_y = p.lid_height * std::sin(angle), top_z = p.lid_height * std::cos(angle);
  const Eigen::Vector3d top_left(-x, top_y, top_z), top_right(x, top_y, top_z), hinge_left(-x, 0, 0),
      hinge_right(x, 0, 0), front_left(-x, 0, p.depth), front_right(x, 0, p.depth);
  return MakeWireframe({{top_left, top_right},
                        {top_left, hinge_left},
                        {hinge_left, hinge_right},
                        {top_right, hinge_right},
                        {hinge_left, front_left},
                        {front_left, front_right},
                        {hinge_right, front_right}});
}

std::vector<std::string> LaptopEdgeNames() {
  return {"screen_top", "screen_left", "hinge", "screen_right", "base_left", "base_front", "base_right"};
}

std::vector<LaptopParameters> SampleLaptopFamily(int count, std::uint64_t seed) {
  Random shape(seed), solid(StreamSeed(seed, 1));
  std::vector<LaptopParameters> laptops;
  for (int i = 0; i < count; ++i) {
    LaptopParameters laptop = DrawShape(shape);
    DrawSolid(solid, laptop);
    laptops.push_back(laptop);
  }
  return laptops;
}

Mesh LaptopMesh(const LaptopParameters& p, const LaptopMaterials& materials) {
  Mesh mesh;
  AddBase(p, materials, mesh);
  AddLid(p, materials, mesh);
  return mesh;
}

}  // namespace armature
