// SPDX-License-Identifier: BSD-3-Clause
// Which tables there are, their wireframes and their surfaces.
#include "datasets/cad/table.h"

#include <algorithm>

#include "datasets/cad/edge_ends.h"
#include "datasets/cad/solids.h"
#include "geometry/random.h"

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

// Kinds of tables, with their shares: what people put into homes and offices.
struct TableKind {
  double share;
  double min_width, max_width;                                 // metres
  double depth_at_min_width, depth_at_max_width, depth_sigma;  // metres: width and depth go together
};

constexpr TableKind kTableKinds[] = {
    {0.25, 0.70, 1.10, 0.66, 1.00, 0.10},  // square and small tables
    {0.35, 1.00, 1.80, 0.64, 0.80, 0.08},  // desks
    {0.25, 1.20, 1.80, 0.76, 0.92, 0.07},  // dining tables
    {0.15, 1.80, 2.30, 0.84, 1.02, 0.08},  // long dining and meeting tables
};

const TableKind& DrawTableKind(Random& random) {
  double left = random.Uniform(0, 1);
  for (const TableKind& kind : kTableKinds) {
    if ((left -= kind.share) < 0) return kind;
  }
  return kTableKinds[0];
}

// The shipped category model is learnt from these numbers: the solid is drawn from a stream of its own.
TableParameters DrawShape(Random& random) {
  const TableKind& kind = DrawTableKind(random);
  TableParameters table;
  const double along = random.Uniform(0, 1);
  table.width = kind.min_width + along * (kind.max_width - kind.min_width);
  const double depth = kind.depth_at_min_width + along * (kind.depth_at_max_width - kind.depth_at_min_width);
  table.depth = std::clamp(random.Normal(depth, kind.depth_sigma), 0.45, std::min(1.10, table.width));
  table.height = std::clamp(random.Normal(0.74, 0.015), 0.70, 0.78);
  // Feet stand close to the corners; on every fourth table they are well under the top.
  table.overhang_z = random.Uniform(0.01, 0.12);
  table.overhang_x = table.overhang_z * random.Uniform(0.8, 1.4);
  if (random.Uniform(0, 1) < 0.25) table.overhang_x += random.Uniform(0, 0.14 * table.width);
  table.overhang_x = std::min(table.overhang_x, 0.22 * table.width);
  if (random.Uniform(0, 1) < 0.15) table.overhang_z += random.Uniform(0, 0.10 * table.depth);
  table.leg_start = random.Uniform(0.0, 0.18);
  if (random.Uniform(0, 1) < 0.20) table.splay = random.Uniform(-0.03, 0.08);
  return table;
}

void DrawSolid(Random& random, TableParameters& table) {
  const double thickness = random.Uniform(0.018, 0.042);
  const bool is_metal = random.Uniform(0, 1) < 0.3;
  table.round_legs = random.Uniform(0, 1) < (is_metal ? 0.4 : 0.2);
  table.leg = is_metal ? random.Uniform(0.025, 0.040) : random.Uniform(0.045, 0.085);
  table.leg_taper = is_metal ? 1.0 : random.Uniform(0.55, 1.0);
  const double shelf = random.Uniform(0.10, 0.25), drawer = random.Uniform(0.30, 0.45);
  const double extra = random.Uniform(0, 1);
  if (extra < 0.12) table.shelf_height = shelf;
  if (extra > 0.80 && table.leg_start > 0.08) table.drawer_width = drawer;
  table.top_thickness = std::clamp(table.leg_start, 0.018, thickness);
  table.leg = std::min(table.leg, 2 * std::max(0.01, std::min(table.overhang_x, table.overhang_z)));
}

}  // namespace

Wireframe TableWireframe(const TableParameters& p) {
  const double x = p.width / 2, z = p.depth / 2;
  const Eigen::Vector3d rear_left(-x, p.height, -z), rear_right(x, p.height, -z), front_right(x, p.height, z),
      front_left(-x, p.height, z);
  const auto leg = [&](double side_x, double side_z) -> EdgeEnds {
    const double top_x = x - p.overhang_x, top_z = z - p.overhang_z;
    return {{side_x * top_x, p.height - p.leg_start, side_z * top_z},
            {side_x * (top_x + p.splay), 0, side_z * (top_z + p.splay)}};
  };
  return MakeWireframe({{rear_left, rear_right},
                        {rear_right, front_right},
                        {front_left, front_right},
                        {rear_left, front_left},
                        leg(-1, -1),
                        leg(1, -1),
                        leg(1, 1),
                        leg(-1, 1)});
}

std::vector<std::string> TableEdgeNames() {
  return {"top_rear",      "top_right",      "top_front",       "top_left",
          "leg_rear_left", "leg_rear_right", "leg_front_right", "leg_front_left"};
}

std::vector<TableParameters> SampleTableFamily(int count, std::uint64_t seed) {
  Random shape(seed), solid(StreamSeed(seed, 1));
  std::vector<TableParameters> tables;
  for (int i = 0; i < count; ++i) {
    TableParameters table = DrawShape(shape);
    DrawSolid(solid, table);
    tables.push_back(table);
  }
  return tables;
}

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
