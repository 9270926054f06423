// SPDX-License-Identifier: BSD-3-Clause
// Which chairs there are, their wireframes and their surfaces. The numbers of the distribution follow
// published chairs (datasets/README.md).
#include "datasets/cad/chair.h"

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
constexpr double kBevel = 0.012;  // of a cushion's upper rim

double Between(double a, double b, double share) { return a + share * (b - a); }

double SeatWidth(const ChairParameters& p, double z) {
  return Between(p.rear_width, p.front_width, z / p.seat_depth);
}
double SeatTop(const ChairParameters& p, double z) { return p.seat_height + p.seat_rise * z / p.seat_depth; }
double SeatBottom(const ChairParameters& p, double z) { return SeatTop(p, z) - p.cushion - p.seat_thickness; }

bool HasPosts(const ChairParameters& p) { return p.back != ChairBack::kShell; }

// In the back's plane: `across` from the left (-1) to the right (1) post's axis, `up` from the seat (0) to
// the top (1).
Vector3d BackPoint(const ChairParameters& p, double across, double up) {
  return {0.5 * across * Between(p.rear_width, p.back_width, up), Between(p.seat_height, p.height, up),
          -p.recline * up};
}

struct Leg {
  Vector3d top, foot;
  Vector3d At(double y) const { return foot + (top - foot) * (y / top.y()); }
};

// Rear legs go on as posts. The others end under the seat, flush with its sides.
Leg RearLeg(const ChairParameters& p, double side) {
  const Vector3d foot(0.5 * side * p.rear_feet, 0, -p.rear_rake);
  if (HasPosts(p)) return {BackPoint(p, side, 0), foot};
  return {{0.5 * side * (p.rear_width - p.leg), SeatBottom(p, 0) + kJoint, 0.5 * p.leg}, foot};
}

Leg FrontLeg(const ChairParameters& p, double side) {
  const double z = p.seat_depth - 0.5 * p.leg;
  return {{0.5 * side * (SeatWidth(p, z) - p.leg), SeatBottom(p, z) + kJoint, z},
          {0.5 * side * p.front_feet, 0, p.seat_depth + p.front_rake}};
}

Part Upright(const ChairParameters& p, const Vector3d& low, const Vector3d& high, double low_thickness,
             const Material& material) {
  if (p.round_legs) return Pole(low, high, 0.5 * low_thickness, 0.5 * p.leg, kRoundSides, material);
  return Beam(low, high, 1, {low_thickness, low_thickness}, {p.leg, p.leg}, material);
}

void AddLegs(const ChairParameters& p, const Material& material, Mesh& mesh) {
  for (const double side : kSides) {
    for (const Leg& leg : {RearLeg(p, side), FrontLeg(p, side)}) {
      mesh.parts.push_back(Upright(p, leg.foot, leg.top, p.leg_taper * p.leg, material));
    }
    if (!HasPosts(p)) continue;
    mesh.parts.push_back(Upright(p, BackPoint(p, side, 0), BackPoint(p, side, 1), p.leg, material));
  }
}

// Corners of the seat `below` its upper side, `inset` from its outline: rear left, front left, front right,
// rear right.
std::array<Vector3d, 4> SeatOutline(const ChairParameters& p, double below, double inset) {
  const auto corner = [&](double side, double z) {
    return Vector3d(side * (0.5 * SeatWidth(p, z) - inset), SeatTop(p, z) - below, z);
  };
  const double rear = inset, front = p.seat_depth - inset;
  return {corner(-1, rear), corner(-1, front), corner(1, front), corner(1, rear)};
}

void AddSeat(const ChairParameters& p, const ChairMaterials& materials, Mesh& mesh) {
  const double bottom = p.cushion + p.seat_thickness;
  const Material& board = p.cushion > 0 ? materials.frame : materials.seat;
  mesh.parts.push_back(Slab(SeatOutline(p, bottom, 0), SeatOutline(p, p.cushion, 0), board));
  if (p.cushion == 0) return;
  const auto rim = SeatOutline(p, kBevel, 0);
  mesh.parts.push_back(Slab(SeatOutline(p, p.cushion, 0), rim, materials.seat));
  mesh.parts.push_back(Slab(rim, SeatOutline(p, 0, 0.7 * kBevel), materials.seat));
}

// A flat piece of the back from `low` to `high` (metres above the seat), `wider` than the distance between
// the posts' axes.
Part Plate(const ChairParameters& p, double low, double high, double wider, const Material& material) {
  const double length = p.height - p.seat_height;
  const Vector3d from = BackPoint(p, 0, low / length), to = BackPoint(p, 0, high / length);
  const auto section = [&](double up) {
    return CrossSection(Between(p.rear_width, p.back_width, up) + wider, p.back_thickness);
  };
  return Beam(from, to, 1, section(low / length), section(high / length), material);
}

void AddSlats(const ChairParameters& p, const ChairMaterials& materials, Mesh& mesh) {
  const double length = p.height - p.seat_height, between_posts = 2 * kJoint - p.leg;
  const double low = (p.back_gap + 0.5 * p.rail) / length, high = (length - p.rail + kJoint) / length;
  mesh.parts.push_back(Plate(p, length - p.rail, length, between_posts, materials.frame));
  mesh.parts.push_back(Plate(p, p.back_gap, p.back_gap + 0.6 * p.rail, between_posts, materials.frame));
  const double gap = p.rear_width / (p.bars + 1);
  const CrossSection section(std::min(0.4 * gap, 0.035), 0.6 * p.back_thickness);
  for (int i = 1; i <= p.bars; ++i) {
    const double across = 2.0 * i / (p.bars + 1) - 1;
    mesh.parts.push_back(
        Beam(BackPoint(p, across, low), BackPoint(p, across, high), 1, section, section, materials.frame));
  }
}

void AddRails(const ChairParameters& p, const ChairMaterials& materials, Mesh& mesh) {
  const double length = p.height - p.seat_height;
  const double rail = std::min(p.rail, 0.6 * (length - p.back_gap) / p.bars);
  const double step = (length - p.back_gap - rail) / (p.bars - 1);
  for (int i = 0; i < p.bars; ++i) {
    const double low = p.back_gap + i * step;
    mesh.parts.push_back(Plate(p, low, low + rail, 2 * kJoint - p.leg, materials.frame));
  }
}

void AddBack(const ChairParameters& p, const ChairMaterials& materials, Mesh& mesh) {
  const double length = p.height - p.seat_height;
  switch (p.back) {
    case ChairBack::kShell:
      mesh.parts.push_back(Plate(p, -p.cushion - p.seat_thickness, length, 0.01, materials.back));
      break;
    case ChairBack::kPanel:
      mesh.parts.push_back(Plate(p, p.back_gap, length - kJoint, 2 * kJoint - p.leg, materials.back));
      break;
    case ChairBack::kSlats:
      AddSlats(p, materials, mesh);
      break;
    case ChairBack::kLadder:
      AddRails(p, materials, mesh);
      break;
  }
}

// A rest from the back to before an upright that stands on the seat's side.
void AddArms(const ChairParameters& p, const Material& material, Mesh& mesh) {
  const double z = p.arm_length * p.seat_depth, thickness = std::max(0.02, 0.7 * p.leg);
  const double length = p.height - p.seat_height, height = std::min(p.arm_height, 0.8 * length);
  const CrossSection rest(0.045, thickness), upright(thickness, thickness);
  for (const double side : kSides) {
    const double x = 0.5 * side * (SeatWidth(p, z) - thickness);
    const Vector3d rear = BackPoint(p, side, height / length), top(x, SeatTop(p, z) + height, z);
    mesh.parts.push_back(Beam(rear, top + Vector3d(0, 0, thickness), 2, rest, rest, material));
    mesh.parts.push_back(
        Beam({x, SeatTop(p, z) - p.cushion - kJoint, z}, top, 1, upright, upright, material));
  }
}

void AddStretchers(const ChairParameters& p, const Material& material, Mesh& mesh) {
  if (p.stretchers == Stretchers::kNone) return;
  const double y = p.stretcher_height, thickness = 0.55 * p.leg;
  const CrossSection section(thickness, thickness);
  const auto across = [&](const Vector3d& left, const Vector3d& right) {
    mesh.parts.push_back(Beam(left, right, 0, section, section, material));
  };
  const auto point = [&](bool front, double side) {
    return (front ? FrontLeg(p, side) : RearLeg(p, side)).At(y);
  };
  for (const double side : kSides) {
    mesh.parts.push_back(Beam(point(false, side), point(true, side), 2, section, section, material));
  }
  if (p.stretchers == Stretchers::kH) {
    across(0.5 * (point(false, -1) + point(true, -1)), 0.5 * (point(false, 1) + point(true, 1)));
  }
  if (p.stretchers == Stretchers::kAround) {
    across(point(false, -1), point(false, 1));
    across(point(true, -1), point(true, 1));
  }
}

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

Mesh ChairMesh(const ChairParameters& p, const ChairMaterials& materials) {
  Mesh mesh;
  AddLegs(p, materials.frame, mesh);
  AddSeat(p, materials, mesh);
  AddBack(p, materials, mesh);
  if (p.arms) AddArms(p, materials.frame, mesh);
  AddStretchers(p, materials.frame, mesh);
  return mesh;
}

}  // namespace armature
