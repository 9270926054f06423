// SPDX-License-Identifier: BSD-3-Clause
// The family of tables: a rectangular top on four straight legs. Built in the frame of the object (y up, long
// side along x), whose origin is here on the floor below the middle of the top; metres.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "drawing/mesh.h"

namespace armature {

struct TableParameters {
  // What the wireframe shows.
  double width = 1.4;        // of the top along x; at least depth
  double depth = 0.8;        // of the top along z
  double height = 0.74;      // of the top's upper side above the floor
  double overhang_x = 0.07;  // from the top's side to the legs' centre line
  double overhang_z = 0.07;
  double leg_start = 0.07;  // how far below the top's upper side the legs begin to be seen
  double splay = 0.0;  // how far the legs' feet stand further out than their tops, along x and z each; may
                       // be negative

  // What only the solid shows. The apron hides the legs down to `leg_start`.
  double top_thickness = 0.03;
  double leg = 0.05;       // thickness at the top; legs do not stand out from under the top
  double leg_taper = 1.0;  // thickness at the floor, share of `leg`
  bool round_legs = false;
  double shelf_height = 0;  // of a shelf between the legs, above the floor; 0: none
  double drawer_width = 0;  // of a drawer under the top, 0: none
};

struct TableMaterials {
  Material top, legs;
};

// Edges in the order of TableEdgeNames(): top rear, right, front, left; legs rear left, rear right, front
// right, left.
Wireframe TableWireframe(const TableParameters& parameters);
std::vector<std::string> TableEdgeNames();

Mesh TableMesh(const TableParameters& parameters, const TableMaterials& materials);

// `count` members drawn from the family's distribution (datasets/README.md); the same for the same seed on
// every platform, and the first n are the same whatever the count.
std::vector<TableParameters> SampleTableFamily(int count, std::uint64_t seed);

}  // namespace armature
