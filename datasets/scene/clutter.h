// SPDX-License-Identifier: BSD-3-Clause
// Things that lie about, and furniture that no category covers: shapes of a scene's clutter.
#pragma once

#include <string>
#include <vector>

#include "drawing/mesh.h"
#include "geometry/random.h"

namespace armature {

// box: of cardboard, taped; cylinder: open at the top and narrower at the bottom, as bins and vases are;
// books: a pile, not quite straight; paper: printed sheets; then the distractors (distractors.h).
const std::vector<std::string>& ClutterShapes();

bool IsDistractor(const std::string& shape);

// Within `size` (metres), z up, on the plane z = 0 with the origin at its centre. A cylinder's diameter is
// the lesser of x and y. Furniture has its front at -y. `random` draws what makes two of a kind differ.
Mesh ClutterMesh(const std::string& shape, const Eigen::Vector3d& size, const Colour& colour, Random& random);

// A muted colour that suits the shape.
Colour DrawClutterColour(const std::string& shape, Random& random);

}  // namespace armature
