// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/furniture.h"

#include <cmath>

#include "geometry/rotation.h"

namespace armature {
namespace {

Cuboid Block(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, const Colour& colour) {
  Cuboid cuboid;
  cuboid.T_parent_cuboid.translation() = centre;
  cuboid.size = size;
  cuboid.colour = colour;
  return cuboid;
}

Furniture Centred(std::string category, std::string instance, std::vector<Cuboid> parts) {
  const Eigen::AlignedBox3d box = BoundingBox(parts);
  for (Cuboid& part : parts) part.T_parent_cuboid.translation() -= box.center();
  return {std::move(category), std::move(instance), std::move(parts), box.sizes()};
}

// The parts of the back in a frame that is turned about the rear of the seat's upper side.
std::vector<Cuboid> ChairBack(const SampleChairParameters& p, const Colour& wood) {
  const double recline = p.recline_deg * kDegree;
  const double length = (p.height - p.seat_height) / std::cos(recline);
  const double inner = p.width - 2 * p.leg;
  std::vector<Cuboid> parts;
  for (const double side : {-1.0, 1.0}) {
    parts.push_back(Block({side * 0.5 * (p.width - p.leg), 0.5 * length, 0}, {p.leg, length, p.leg}, wood));
  }
  parts.push_back(Block({0, length - 0.5 * p.rail, 0}, {inner, p.rail, 0.7 * p.leg}, wood));
  const double low = 0.12, slat_length = length - p.rail - low;
  parts.push_back(Block({0, low, 0}, {inner, 0.03, 0.7 * p.leg}, wood));
  for (int i = 1; i <= p.slats; ++i) {
    const double x = -0.5 * inner + inner * i / (p.slats + 1);
    parts.push_back(Block({x, low + 0.5 * slat_length, 0}, {0.03, slat_length, 0.4 * p.leg}, wood));
  }
  Eigen::Isometry3d T_object_back = Eigen::Isometry3d::Identity();
  T_object_back.translation() = Eigen::Vector3d(0, p.seat_height, -0.5 * (p.depth - p.leg));
  T_object_back.rotate(Eigen::AngleAxisd(-recline, Eigen::Vector3d::UnitX()));
  for (Cuboid& part : parts) part.T_parent_cuboid = T_object_back * part.T_parent_cuboid;
  return parts;
}

}  // namespace

Furniture SolidChair(const SampleChairParameters& p, const Colour& wood, const Colour& seat,
                     const std::string& instance) {
  std::vector<Cuboid> parts = ChairBack(p, wood);
  const double leg_height = p.seat_height - p.seat_thickness;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      parts.push_back(Block({x * 0.5 * (p.width - p.leg), 0.5 * leg_height, z * 0.5 * (p.depth - p.leg)},
                            {p.leg, leg_height, p.leg}, wood));
    }
  }
  parts.push_back(
      Block({0, p.seat_height - 0.5 * p.seat_thickness, 0}, {p.width, p.seat_thickness, p.depth}, seat));
  return Centred("chair", instance, parts);
}

Furniture SolidTable(const TableParameters& p, const Colour& top, const Colour& legs,
                     const std::string& instance) {
  constexpr double kTop = 0.03, kLeg = 0.055;
  const double leg_x = 0.5 * p.width - p.overhang_x, leg_z = 0.5 * p.depth - p.overhang_z;
  const double leg_height = p.height - kTop, apron = p.leg_start - kTop;
  std::vector<Cuboid> parts = {Block({0, p.height - 0.5 * kTop, 0}, {p.width, kTop, p.depth}, top)};
  for (const double sign : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      parts.push_back(Block({sign * leg_x, 0.5 * leg_height, z * leg_z}, {kLeg, leg_height, kLeg}, legs));
    }
    if (apron <= 0) continue;
    const double y = leg_height - 0.5 * apron;
    parts.push_back(Block({0, y, sign * leg_z}, {2 * leg_x, apron, 0.5 * kLeg}, legs));
    parts.push_back(Block({sign * leg_x, y, 0}, {0.5 * kLeg, apron, 2 * leg_z}, legs));
  }
  return Centred("table", instance, parts);
}

Furniture SolidLaptop(const LaptopParameters& p, const std::string& instance) {
  constexpr double kBase = 0.014, kLid = 0.006;
  const Colour metal(0.25, 0.26, 0.28), keys(0.08, 0.08, 0.09), screen(0.55, 0.72, 0.9);
  std::vector<Cuboid> parts = {
      Block({0, 0.5 * kBase, 0}, {p.width, kBase, p.depth}, metal),
      Block({0, kBase, -0.12 * p.depth}, {0.86 * p.width, 0.002, 0.45 * p.depth}, keys)};
  Eigen::Isometry3d T_object_lid = Eigen::Isometry3d::Identity();
  T_object_lid.translation() = Eigen::Vector3d(0, kBase, -0.5 * p.depth);
  T_object_lid.rotate(Eigen::AngleAxisd(-(p.lid_angle_deg - 90) * kDegree, Eigen::Vector3d::UnitX()));
  std::vector<Cuboid> lid = {
      Block({0, 0.5 * p.lid_height, 0}, {p.width, p.lid_height, kLid}, metal),
      Block({0, 0.5 * p.lid_height, 0.5 * kLid}, {0.9 * p.width, 0.86 * p.lid_height, 0.002}, screen)};
  for (Cuboid& part : lid) {
    part.T_parent_cuboid = T_object_lid * part.T_parent_cuboid;
    parts.push_back(part);
  }
  return Centred("laptop", instance, parts);
}

}  // namespace armature
