// SPDX-License-Identifier: BSD-3-Clause
// Furniture of a few blocks with the sizes that real furniture has, for tests of scenes.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "datasets/cad/cad_instance.h"
#include "datasets/cad/solids.h"

namespace armature::testing {

inline CadInstance BlockInstance(const std::string& id, const std::string& category,
                                 const Eigen::Vector3d& size, const std::vector<Part>& parts) {
  CadInstance instance;
  instance.id = id;
  instance.category = category;
  instance.mesh.parts = parts;
  instance.size = size;
  instance.held_out = id.back() == '0';
  return instance;
}

// A block between two corners given as shares of the size, -0.5..0.5.
inline Part MakePart(const Eigen::Vector3d& size, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return Block(Eigen::Vector3d(size.cwiseProduct(low)), Eigen::Vector3d(size.cwiseProduct(high)), Material());
}

// Seat and what is below it as one block, and a back.
inline CadInstance BlockChair(const std::string& id, const Eigen::Vector3d& size) {
  return BlockInstance(id, "chair", size,
                       {MakePart(size, {-0.5, -0.5, -0.5}, {0.5, 0.0, 0.5}),
                        MakePart(size, {-0.5, 0.0, -0.5}, {0.5, 0.5, -0.4})});
}

// A top on four legs.
inline CadInstance BlockTable(const std::string& id, const Eigen::Vector3d& size) {
  std::vector<Part> parts{MakePart(size, {-0.5, 0.45, -0.5}, {0.5, 0.5, 0.5})};
  for (const double x : {-0.5, 0.44}) {
    for (const double z : {-0.5, 0.44}) {
      parts.push_back(MakePart(size, {x, -0.5, z}, {x + 0.06, 0.45, z + 0.06}));
    }
  }
  return BlockInstance(id, "table", size, parts);
}

// Base and lid.
inline CadInstance BlockLaptop(const std::string& id, const Eigen::Vector3d& size) {
  return BlockInstance(id, "laptop", size,
                       {MakePart(size, {-0.5, -0.5, -0.3}, {0.5, -0.45, 0.5}),
                        MakePart(size, {-0.5, -0.5, -0.5}, {0.5, 0.5, -0.3})});
}

// Two of a category, the first not held out: chair-0001, chair-0010, table-0001, ...; `scale` of the
// footprints.
inline std::vector<CadInstance> BlockCollection(double scale = 1) {
  std::vector<CadInstance> collection;
  for (const char* number : {"0001", "0010"}) {
    collection.push_back(BlockChair(fmt::format("chair-{}", number), {0.46 * scale, 0.9, 0.52 * scale}));
  }
  for (const char* number : {"0001", "0010"}) {
    collection.push_back(BlockTable(fmt::format("table-{}", number), {1.3 * scale, 0.74, 0.75 * scale}));
  }
  for (const char* number : {"0001", "0010"}) {
    collection.push_back(BlockLaptop(fmt::format("laptop-{}", number), {0.34 * scale, 0.23, 0.3 * scale}));
  }
  return collection;
}

}  // namespace armature::testing
