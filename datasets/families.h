// SPDX-License-Identifier: BSD-3-Clause
// Parametric furniture: our own families of tables and laptops, from which shipped category models are learnt
// and rooms are furnished. Wireframes are in metres in the object frame (y up, front +z), centred.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "category/category_model.h"

namespace armature {

// A table with a rectangular top and four straight legs.
struct TableParameters {
  double width = 1.4;        // of the top along x, metres; at least depth
  double depth = 0.8;        // of the top along z, metres
  double height = 0.74;      // of the top's upper side above the floor, metres
  double overhang_x = 0.07;  // from the top's side to the legs' centre line, metres
  double overhang_z = 0.07;
  double leg_start = 0.07;  // how far below the top's upper side the legs begin to be seen, metres
  double splay = 0.0;       // how far the legs' feet stand further out than their tops, along x and z each,
                            // metres; may be negative
};

// A laptop: two rectangles that meet at the hinge; thickness is not modelled.
struct LaptopParameters {
  double width = 0.34;         // along x, metres
  double depth = 0.24;         // of the base along z, metres
  double lid_height = 0.225;   // of the screen from hinge to top, metres
  double lid_angle_deg = 110;  // between base and screen
};

// Edges in the order of TableEdgeNames(): top rear, right, front, left; legs rear left, rear right, front
// right, left.
Wireframe TableWireframe(const TableParameters& parameters);
std::vector<std::string> TableEdgeNames();

// Edges in the order of LaptopEdgeNames(): screen top, left, hinge, right; base left, front, right.
Wireframe LaptopWireframe(const LaptopParameters& parameters);
std::vector<std::string> LaptopEdgeNames();

// `count` members drawn from the family's distribution (datasets/README.md); the same for the same seed on
// every platform.
std::vector<TableParameters> SampleTableFamily(int count, std::uint64_t seed);
std::vector<LaptopParameters> SampleLaptopFamily(int count, std::uint64_t seed);

}  // namespace armature
