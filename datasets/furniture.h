// SPDX-License-Identifier: BSD-3-Clause
// Solid furniture from a few measures, to be drawn. Object frame: y up, front +z, origin at the centre of the
// bounding box; metres.
#pragma once

#include <string>
#include <vector>

#include "datasets/cad/laptop.h"
#include "datasets/cad/table.h"
#include "datasets/solids.h"

namespace armature {

struct Furniture {
  std::string category;
  std::string instance;           // "sample:name"
  std::vector<Cuboid> parts;      // in the object frame
  Eigen::Vector3d size{0, 0, 0};  // of the bounding box
};

// Four legs, a seat, a reclined back with a top rail and upright slats.
struct SampleChairParameters {
  double width = 0.44;        // along x
  double depth = 0.43;        // of the seat along z
  double seat_height = 0.45;  // of the seat's upper side
  double height = 0.88;       // of the back's top
  double recline_deg = 8;     // of the back, from the vertical
  double leg = 0.036;         // thickness of legs and posts
  double seat_thickness = 0.035;
  double rail = 0.07;  // height of the back's top rail
  int slats = 3;
};

Furniture SolidChair(const SampleChairParameters& parameters, const Colour& wood, const Colour& seat,
                     const std::string& instance);

// Top, four legs, an apron between them.
Furniture SolidTable(const TableParameters& parameters, const Colour& top, const Colour& legs,
                     const std::string& instance);

// Base with a keyboard, lid with a lit screen.
Furniture SolidLaptop(const LaptopParameters& parameters, const std::string& instance);

}  // namespace armature
