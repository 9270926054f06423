// SPDX-License-Identifier: BSD-3-Clause
// What stands on what: a laptop on a table, or on the seat of a chair.
#pragma once

#include <vector>

#include "mapping/map_graph.h"
#include "resection/resection_problem.h"

namespace armature {

struct Support {
  int object = 0;  // stands
  int on = 0;      // that object,
  int face = 0;    // that face of its category
};

// For each object of a category that does not stand on the floor: the level face of another object that it is
// over and whose height is nearest to that of its lowest point, if any is near enough.
std::vector<Support> FindSupports(const MapGraph& graph);

// The middle of the face's corners.
ShapePoint FaceCentre(const CategoryModel& model, int face);

}  // namespace armature
