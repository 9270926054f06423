// SPDX-License-Identifier: BSD-3-Clause
// Which laptops there are, and their wireframes.
#include "datasets/cad/laptop.h"

#include <algorithm>
#include <cmath>

#include "datasets/cad/edge_ends.h"
#include "geometry/random.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

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

}  // namespace armature
