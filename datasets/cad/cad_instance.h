// SPDX-License-Identifier: BSD-3-Clause
// One annotated CAD model that can be placed in a scene: of our own families, or of a collection on disk.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "category/category_model.h"
#include "drawing/mesh.h"

namespace armature {

// Mesh and edges are in the object frame (y up, front +z), its origin at the centre of the mesh's bounding
// box, metres.
struct CadInstance {
  std::string id;                       // "chair-0007"
  std::string category;                 // "chair"
  std::string collection = "armature";  // as scenes name it
  std::string prefix = "armature:";     // of its name in ground truth and libraries
  Mesh mesh;
  std::function<Mesh()> read_mesh;  // of collections on disk: read when it is needed, see Loaded()
  Wireframe wireframe;              // edges in the order of EdgeNames
  Eigen::Vector3d size{0, 0, 0};    // of the mesh's bounding box
  std::optional<double> lid_deg;    // of a laptop that was opened differently from its model
  bool held_out = false;            // not to be learnt from: for sequences and retrieval queries
};

struct CollectionOptions {
  int chairs = 340, tables = 170, laptops = 170;
  std::uint64_t seed = 1;
};

// Chairs, tables, laptops, in this order, drawn from the families; every tenth of a category is held out. The
// same for the same options on every platform; the first n are the same whatever the counts.
std::vector<CadInstance> DrawCollection(const CollectionOptions& options);

// The names of a category's edges, as in configs/categories/specs. Aborts for an unknown category.
std::vector<std::string> EdgeNames(const std::string& category);

}  // namespace armature
