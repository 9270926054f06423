// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cstdlib>

#include "datasets/cad/cad_instance.h"
#include "datasets/cad/chair.h"
#include "datasets/cad/edge_ends.h"
#include "datasets/cad/laptop.h"
#include "datasets/cad/materials.h"
#include "datasets/cad/table.h"
#include "geometry/random.h"

namespace armature {
namespace {

constexpr int kHeldOutEvery = 10;

// Streams of random numbers. The collection's shapes are not the members that the shipped category models are
// learnt from, which have the seed itself: held-out ones would not be held out.
enum Stream : std::uint64_t { kShapes = 100, kMaterials = 101 };

// Brings mesh and wireframe of one frame into the object frame.
CadInstance Instance(const std::string& category, int number, const Mesh& mesh, const Wireframe& wireframe) {
  const Eigen::AlignedBox3d box = BoundingBox(mesh);
  CadInstance instance;
  instance.id = fmt::format("{}-{:04}", category, number);
  instance.category = category;
  instance.mesh = Shifted(mesh, -box.center());
  instance.wireframe = Shifted(wireframe, -box.center());
  instance.size = box.sizes();
  instance.held_out = number % kHeldOutEvery == 0;
  unsigned seed = 1000 * static_cast<unsigned>(number);
  for (Part& part : instance.mesh.parts) part.material.seed = seed++;
  return instance;
}

void AddChairs(int count, std::uint64_t seed, std::vector<CadInstance>& collection) {
  Random random(StreamSeed(seed, kMaterials));
  int number = 0;
  for (const ChairParameters& chair : SampleChairFamily(count, StreamSeed(seed, kShapes))) {
    const Mesh mesh = ChairMesh(chair, DrawChairMaterials(random, chair));
    collection.push_back(Instance("chair", ++number, mesh, ChairWireframe(chair)));
  }
}

void AddTables(int count, std::uint64_t seed, std::vector<CadInstance>& collection) {
  Random random(StreamSeed(seed, kMaterials));
  int number = 0;
  for (const TableParameters& table : SampleTableFamily(count, StreamSeed(seed, kShapes))) {
    const Mesh mesh = TableMesh(table, DrawTableMaterials(random, table));
    collection.push_back(Instance("table", ++number, mesh, TableWireframe(table)));
  }
}

void AddLaptops(int count, std::uint64_t seed, std::vector<CadInstance>& collection) {
  Random random(StreamSeed(seed, kMaterials));
  int number = 0;
  for (const LaptopParameters& laptop : SampleLaptopFamily(count, StreamSeed(seed, kShapes))) {
    const Mesh mesh = LaptopMesh(laptop, DrawLaptopMaterials(random));
    collection.push_back(Instance("laptop", ++number, mesh, LaptopWireframe(laptop)));
  }
}

}  // namespace

std::vector<CadInstance> DrawCollection(const CollectionOptions& options) {
  std::vector<CadInstance> collection;
  AddChairs(options.chairs, options.seed, collection);
  AddTables(options.tables, options.seed, collection);
  AddLaptops(options.laptops, options.seed, collection);
  return collection;
}

std::vector<std::string> EdgeNames(const std::string& category) {
  if (category == "chair") return ChairEdgeNames();
  if (category == "table") return TableEdgeNames();
  if (category == "laptop") return LaptopEdgeNames();
  std::abort();
}

}  // namespace armature
