// SPDX-License-Identifier: BSD-3-Clause
// Furniture that no category covers: it hides what is behind it, and detectors take it for chairs and tables.
#pragma once

#include <string>
#include <vector>

#include "drawing/mesh.h"
#include "geometry/random.h"

namespace armature {

// sofa, stool, cabinet (doors or drawers), shelf (open, with books), plant (in a pot), round_table.
const std::vector<std::string>& DistractorShapes();

// As ClutterMesh() has it. `colour`: of its fabric, wood or pot.
Mesh DistractorMesh(const std::string& shape, const Eigen::Vector3d& size, const Colour& colour,
                    Random& random);

Colour DrawDistractorColour(const std::string& shape, Random& random);

// As such furniture is built: width, depth and height, metres.
Eigen::Vector3d DrawDistractorSize(const std::string& shape, Random& random);

}  // namespace armature
