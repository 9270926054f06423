// SPDX-License-Identifier: BSD-3-Clause
// Wireframes from the ends of their edges.
#pragma once

#include <vector>

#include "category/category_model.h"

namespace armature {

struct EdgeEnds {
  Eigen::Vector3d start, end;  // metres
};

// In the frame of the ends; not centred.
Wireframe MakeWireframe(const std::vector<EdgeEnds>& edges);

// The wireframe moved.
Wireframe Shifted(const Wireframe& wireframe, const Eigen::Vector3d& shift);

}  // namespace armature
