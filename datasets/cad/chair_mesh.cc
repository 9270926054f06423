// SPDX-License-Identifier: BSD-3-Clause
// The solid chair around its wireframe.
#include <algorithm>

#include "datasets/cad/chair.h"
#include "datasets/cad/solids.h"

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

}  // namespace

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
