// SPDX-License-Identifier: BSD-3-Clause
// Which tables there are, and their wireframes.
#include "datasets/cad/table.h"

#include <algorithm>

#include "datasets/cad/edge_ends.h"
#include "geometry/random.h"

namespace armature {
namespace {

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

}  // namespace armature
