// SPDX-License-Identifier: BSD-3-Clause
// The solid table around its wireframe.
#include "datasets/cad/solids.h"
#include "datasets/cad/table.h"

namespace armature {
namespace {

using Eigen::Vector3d;

constexpr double kSides[] = {-1, 1};
constexpr int kRoundSides = 10;   // of a round leg
constexpr double kJoint = 0.002;  // how deep a piece sits in another
constexpr double kBoard = 0.018;  // thickness of aprons, shelves and fronts
constexpr double kDrawer = 0.11;  // height of a drawer

double TopBottom(const TableParameters& p) { return p.height - p.top_thickness; }

// The leg's axis at a height; the wireframe's edge goes along it.
Vector3d LegPoint(const TableParameters& p, double side_x, double side_z, double y) {
  const double out = p.splay * (1 - y / (p.height - p.leg_start));
  return {side_x * (0.5 * p.width - p.overhang_x + out), y, side_z * (0.5 * p.depth - p.overhang_z + out)};
}

void AddLegs(const TableParameters& p, const Material& material, Mesh& mesh) {
  const double foot = p.leg_taper * p.leg;
  for (const double x : kSides) {
    for (const double z : kSides) {
      const Vector3d low = LegPoint(p, x, z, 0), high = LegPoint(p, x, z, TopBottom(p) + kJoint);
      mesh.parts.push_back(p.round_legs ? Pole(low, high, 0.5 * foot, 0.5 * p.leg, kRoundSides, material)
                                        : Beam(low, high, 1, {foot, foot}, {p.leg, p.leg}, material));
    }
  }
}

// Boards between the legs under the top.
void AddApron(const TableParameters& p, const Material& material, Mesh& mesh) {
  const double height = p.leg_start - p.top_thickness;
  if (height < 0.01) return;
  const double y = TopBottom(p) - 0.5 * height + 0.5 * kJoint;
  const CrossSection along_x(height, kBoard), along_z(kBoard, height);
  for (const double side : kSides) {
    mesh.parts.push_back(
        Beam(LegPoint(p, -1, side, y), LegPoint(p, 1, side, y), 0, along_x, along_x, material));
    mesh.parts.push_back(
        Beam(LegPoint(p, side, -1, y), LegPoint(p, side, 1, y), 2, along_z, along_z, material));
  }
}

void AddShelf(const TableParameters& p, const Material& material, Mesh& mesh) {
  if (p.shelf_height <= 0) return;
  const Vector3d corner = LegPoint(p, 1, 1, p.shelf_height);
  mesh.parts.push_back(Block(Vector3d(-corner.x(), corner.y() - kBoard, -corner.z()), corner, material));
}

// A box under the top whose front with its knob stands before the apron.
void AddDrawer(const TableParameters& p, const TableMaterials& materials, Mesh& mesh) {
  if (p.drawer_width <= 0) return;
  const double top = TopBottom(p), front = LegPoint(p, 1, 1, top).z() + 0.5 * kBoard;
  const double half = 0.5 * p.drawer_width;
  mesh.parts.push_back(Block(Vector3d(-half + 0.01, top - kDrawer + 0.01, -0.3 * p.depth),
                             Vector3d(half - 0.01, top + kJoint, front), materials.legs));
  mesh.parts.push_back(Block(Vector3d(-half, top - kDrawer, front - kJoint),
                             Vector3d(half, top - 0.004, front + 0.01), materials.top));
  const Vector3d knob(0, top - 0.5 * kDrawer, front + 0.01 - kJoint);
  mesh.parts.push_back(
      Cylinder(knob, knob + Vector3d(0, 0, 0.022), 0.009, 0.012, kRoundSides, materials.legs));
}

}  // namespace

Mesh TableMesh(const TableParameters& p, const TableMaterials& materials) {
  Mesh mesh;
  mesh.parts.push_back(Block(Vector3d(-0.5 * p.width, TopBottom(p), -0.5 * p.depth),
                             Vector3d(0.5 * p.width, p.height, 0.5 * p.depth), materials.top));
  AddLegs(p, materials.legs, mesh);
  AddApron(p, materials.legs, mesh);
  AddShelf(p, materials.top, mesh);
  AddDrawer(p, materials, mesh);
  return mesh;
}

}  // namespace armature
