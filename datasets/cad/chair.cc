// SPDX-License-Identifier: BSD-3-Clause
// Which chairs there are, and their wireframes. The numbers of the distribution follow published chairs
// (datasets/README.md).
#include "datasets/cad/chair.h"

#include <algorithm>

#include "datasets/cad/edge_ends.h"
#include "geometry/random.h"

namespace armature {
namespace {

// Shapes depend on each other as in real chairs: deep seats are wide, wide seats taper less, feet that are
// splayed in front are so at the rear, and a raked back goes with raked rear legs.
void DrawShape(Random& random, ChairParameters& chair) {
  chair.arms = random.Uniform(0, 1) < 0.35;
  chair.seat_height = std::clamp(random.Normal(0.45, 0.013), 0.415, 0.485);
  chair.seat_rise = std::clamp(random.Normal(-0.006, 0.022), -0.05, 0.05);
  chair.seat_depth = random.Normal(chair.arms ? 0.432 : 0.395, 0.077);
  const double deep = chair.seat_depth - 0.408;
  chair.rear_width = 0.429 + 0.58 * deep + random.Normal(0, 0.073);
  const double wide = chair.rear_width - 0.429;
  const double taper = 0.024 - 0.29 * wide + random.Normal(0, 0.044);
  chair.front_width = chair.rear_width + taper;
  chair.back_width = chair.rear_width + 0.015 + 0.45 * (taper - 0.024) + random.Normal(0, 0.060);
  const double splay = random.Normal(chair.arms ? 0.043 : -0.010, 0.060);
  chair.front_feet = chair.front_width + splay;
  chair.rear_feet =
      chair.rear_width + 0.013 + 0.75 * splay + 0.45 * (taper - 0.024) + random.Normal(0, 0.045);
  chair.height = 0.893 + 0.35 * deep - 0.35 * splay + random.Normal(0, 0.105);
  const double raked = random.Normal(0, 1);
  chair.recline = std::max(-0.01, 0.070 + 0.047 * raked + random.Normal(0, 0.046));
  chair.rear_rake = std::max(-0.02, 0.070 + 0.047 * raked + random.Normal(0, 0.048));
  chair.front_rake = -0.016 - 0.15 * deep + random.Normal(0, 0.041);
}

// As a chair's, not a stool's, a bench's or a throne's.
bool IsChairLike(const ChairParameters& chair) {
  const Eigen::Vector3d size = BoundingBoxSize(ChairWireframe(chair));
  const double narrowest = std::min({chair.rear_width, chair.front_width, chair.back_width, chair.rear_feet,
                                     chair.front_feet, chair.seat_depth});
  return (size.array() > Eigen::Array3d(0.36, 0.66, 0.36)).all() &&
         (size.array() < Eigen::Array3d(0.69, 1.18, 0.79)).all() && narrowest > 0.26;
}

ChairBack DrawBack(Random& random) {
  const double kind = random.Uniform(0, 1);
  if (kind < 0.28) return ChairBack::kShell;
  if (kind < 0.50) return ChairBack::kPanel;
  return kind < 0.78 ? ChairBack::kSlats : ChairBack::kLadder;
}

void DrawBackMeasures(Random& random, ChairParameters& chair) {
  const bool is_padded = random.Uniform(0, 1) < 0.4;
  chair.back = DrawBack(random);
  const double above_seat = chair.height - chair.seat_height;
  chair.back_gap = random.Uniform(0.12, chair.back == ChairBack::kPanel ? 0.45 : 0.30) * above_seat;
  chair.rail = random.Uniform(0.04, 0.09);
  chair.bars =
      static_cast<int>(chair.back == ChairBack::kSlats ? random.Uniform(3, 9) : random.Uniform(2, 5));
  chair.back_thickness = chair.leg * random.Uniform(0.4, 0.7);
  if (chair.back == ChairBack::kShell) chair.back_thickness = is_padded ? 0.05 : random.Uniform(0.012, 0.02);
  if (chair.back == ChairBack::kPanel && is_padded) chair.back_thickness = chair.leg + 0.01;
}

void DrawSolid(Random& random, ChairParameters& chair) {
  const bool is_metal = random.Uniform(0, 1) < 0.3;
  chair.round_legs = random.Uniform(0, 1) < (is_metal ? 0.6 : 0.3);
  chair.leg = is_metal ? random.Uniform(0.018, 0.025) : random.Uniform(0.030, 0.045);
  chair.leg_taper = is_metal ? 1.0 : random.Uniform(0.55, 1.0);
  DrawBackMeasures(random, chair);
  chair.seat_thickness = random.Uniform(0.016, 0.045);
  const double cushion = random.Uniform(0.02, 0.05);
  chair.cushion = random.Uniform(0, 1) < 0.4 ? cushion : 0;
  chair.arm_height = random.Uniform(0.17, 0.25);
  chair.arm_length = random.Uniform(0.6, 0.95);
  const double stretchers = random.Uniform(0, 1);
  chair.stretchers = stretchers < 0.5    ? Stretchers::kNone
                     : stretchers < 0.65 ? Stretchers::kSides
                     : stretchers < 0.85 ? Stretchers::kH
                                         : Stretchers::kAround;
  chair.stretcher_height = random.Uniform(0.10, 0.25);
}

}  // namespace

Wireframe ChairWireframe(const ChairParameters& p) {
  const auto at = [](double side, double width, double y, double z) {
    return Eigen::Vector3d(0.5 * side * width, y, z);
  };
  const auto top = [&](double side) { return at(side, p.back_width, p.height, -p.recline); };
  const auto rear = [&](double side) { return at(side, p.rear_width, p.seat_height, 0); };
  const auto front = [&](double side) {
    return at(side, p.front_width, p.seat_height + p.seat_rise, p.seat_depth);
  };
  const auto rear_foot = [&](double side) { return at(side, p.rear_feet, 0, -p.rear_rake); };
  const auto front_foot = [&](double side) { return at(side, p.front_feet, 0, p.seat_depth + p.front_rake); };
  return MakeWireframe({{top(-1), top(1)},
                        {top(-1), rear(-1)},
                        {top(1), rear(1)},
                        {rear(-1), rear(1)},
                        {front(-1), front(1)},
                        {rear(-1), front(-1)},
                        {rear(1), front(1)},
                        {front(-1), front_foot(-1)},
                        {rear(-1), rear_foot(-1)},
                        {rear(1), rear_foot(1)},
                        {front(1), front_foot(1)}});
}

std::vector<std::string> ChairEdgeNames() {
  return {"back_top",   "back_left",      "back_right",    "seat_rear",      "seat_front",     "seat_left",
          "seat_right", "leg_front_left", "leg_rear_left", "leg_rear_right", "leg_front_right"};
}

std::vector<ChairParameters> SampleChairFamily(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<ChairParameters> chairs;
  while (static_cast<int>(chairs.size()) < count) {
    ChairParameters chair;
    DrawShape(random, chair);
    DrawSolid(random, chair);
    if (IsChairLike(chair)) chairs.push_back(chair);
  }
  return chairs;
}

}  // namespace armature
