// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/families.h"

#include <algorithm>
#include <cmath>

#include "category/normalise.h"
#include "datasets/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

struct Ends {
  Eigen::Vector3d start, end;
};

Wireframe FromEnds(const std::vector<Ends>& edges) {
  const auto count = static_cast<Eigen::Index>(edges.size());
  Wireframe wireframe{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [start, end] = edges[static_cast<size_t>(i)];
    wireframe.midpoints.col(i) = (start + end) / 2;
    wireframe.directions.col(i) = end - start;
  }
  return Centred(wireframe);
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

TableParameters DrawTable(Random& random) {
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

LaptopParameters DrawLaptop(Random& random) {
  LaptopParameters laptop;
  laptop.width = std::clamp(random.Normal(0.34, 0.025), 0.28, 0.40);
  laptop.depth = laptop.width * std::clamp(random.Normal(0.71, 0.06), 0.58, 0.90);
  laptop.lid_height = laptop.depth * random.Normal(0.93, 0.07);
  laptop.lid_angle_deg = std::clamp(random.Normal(106, 12), 90.0, 135.0);
  return laptop;
}

}  // namespace

Wireframe TableWireframe(const TableParameters& p) {
  const double x = p.width / 2, z = p.depth / 2;
  const Eigen::Vector3d rear_left(-x, p.height, -z), rear_right(x, p.height, -z), front_right(x, p.height, z),
      front_left(-x, p.height, z);
  const auto leg = [&](double side_x, double side_z) -> Ends {
    const double top_x = x - p.overhang_x, top_z = z - p.overhang_z;
    return {{side_x * top_x, p.height - p.leg_start, side_z * top_z},
            {side_x * (top_x + p.splay), 0, side_z * (top_z + p.splay)}};
  };
  return FromEnds({{rear_left, rear_right},
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

Wireframe LaptopWireframe(const LaptopParameters& p) {
  const double x = p.width / 2, angle = p.lid_angle_deg * kDegree;
  const double top_y = p.lid_height * std::sin(angle), top_z = p.lid_height * std::cos(angle);
  const Eigen::Vector3d top_left(-x, top_y, top_z), top_right(x, top_y, top_z), hinge_left(-x, 0, 0),
      hinge_right(x, 0, 0), front_left(-x, 0, p.depth), front_right(x, 0, p.depth);
  return FromEnds({{top_left, top_right},
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

std::vector<TableParameters> SampleTableFamily(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<TableParameters> tables;
  for (int i = 0; i < count; ++i) tables.push_back(DrawTable(random));
  return tables;
}

std::vector<LaptopParameters> SampleLaptopFamily(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<LaptopParameters> laptops;
  for (int i = 0; i < count; ++i) laptops.push_back(DrawLaptop(random));
  return laptops;
}

}  // namespace armature
