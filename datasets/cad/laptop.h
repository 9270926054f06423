// SPDX-License-Identifier: BSD-3-Clause
// The family of laptops: a base and a lid that meet at the hinge. Built in the frame of the object (y up, the
// screen faces +z), whose origin is here the hinge's middle at the height of the base's upper side; metres.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "drawing/mesh.h"

namespace armature {

struct LaptopParameters {
  // What the wireframe shows: the base's upper side and the lid's front, two rectangles.
  double width = 0.34;         // along x
  double depth = 0.24;         // of the base along z
  double lid_height = 0.225;   // of the screen from hinge to top
  double lid_angle_deg = 110;  // between base and screen

  // What only the solid shows.
  double base_thickness = 0.016, lid_thickness = 0.006;
  double bezel = 0.012;  // around the lit screen; above the hinge twice that
};

struct LaptopMaterials {
  Material body, bezel, screen, keyboard, touchpad;
};

// Edges in the order of LaptopEdgeNames(): screen top, left, hinge, right; base left, front, right.
Wireframe LaptopWireframe(const LaptopParameters& parameters);
std::vector<std::string> LaptopEdgeNames();

Mesh LaptopMesh(const LaptopParameters& parameters, const LaptopMaterials& materials);

// `count` members drawn from the family's distribution (datasets/README.md); the same for the same seed on
// every platform, and the first n are the same whatever the count.
std::vector<LaptopParameters> SampleLaptopFamily(int count, std::uint64_t seed);

}  // namespace armature
