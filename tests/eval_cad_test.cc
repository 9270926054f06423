// SPDX-License-Identifier: BSD-3-Clause
// The CAD models that `armature generate` writes, as the evaluation reads them.
#include <gtest/gtest.h>

#include "support/expect_input_error.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::ExpectInputError;

const std::string kInstances = "id,category,held_out,size_x,size_y,size_z,mesh\n";

// All edges of the category, the i-th from (x, 0, 0) to (x, 1, 0) with x = i + shift.
std::string EdgesOf(const std::string& model, const CategorySpec& spec, double shift) {
  std::string rows;
  for (int i = 0; i < spec.edges(); ++i) {
    const double x = i + shift;
    rows += fmt::format("{},{},{},0,0,{},1,0\n", model, spec.edge_names[static_cast<size_t>(i)], x, x);
  }
  return rows;
}

class GeneratedCad : public ::testing::Test {
 protected:
  GeneratedCad() {
    const CategorySpec& table = SpecOf(specs_, "table");
    const std::string header = "model,edge,x1,y1,z1,x2,y2,z2\n";
    WriteInstances("table-0001,table,0,1.2,0.7,0.6,mesh/a.ply\ntable-0010,table,1,2,0.7,0.6,mesh/b.ply\n");
    folder_.Write("table_edges.csv", header + EdgesOf("table-0001", table, 0));
    folder_.Write("table_edges_held_out.csv", header + EdgesOf("table-0010", table, 0.5));
  }
  void WriteInstances(const std::string& rows) const { folder_.Write("instances.csv", kInstances + rows); }
  std::optional<Wireframe> EdgesOfTable(const std::string& id, const Eigen::Vector3d& size) const {
    TrueObject object{"table0", "table", "armature:" + id};
    object.size = size;
    return CadLibrary(folder_.path(), specs_).EdgesOf(object);
  }
  void ExpectRefused(const std::vector<std::string>& texts) const {
    ExpectInputError([&] { CadLibrary(folder_.path(), specs_); }, texts);
  }

  testing::TempFolder folder_;
  std::vector<CategorySpec> specs_ = testing::ShippedSpecs();
};

TEST_F(GeneratedCad, EdgesAreAsTheyAreWritten) {
  const auto edges = EdgesOfTable("table-0001", {1.2, 0.7, 0.6});
  ASSERT_TRUE(edges);
  EXPECT_TRUE(edges->midpoints.col(3).isApprox(Eigen::Vector3d(3, 0.5, 0)));
  EXPECT_TRUE(edges->directions.col(3).isApprox(Eigen::Vector3d(0, 1, 0)));
}

TEST_F(GeneratedCad, HeldOutOnesHaveAFileOfTheirOwn) {
  const auto edges = EdgesOfTable("table-0010", {2, 0.7, 0.6});
  ASSERT_TRUE(edges);
  EXPECT_TRUE(edges->midpoints.col(3).isApprox(Eigen::Vector3d(3.5, 0.5, 0)));
}

TEST_F(GeneratedCad, OtherInstancesAreNotKnown) { EXPECT_FALSE(EdgesOfTable("table-0002", {2, 0.7, 0.6})); }

TEST_F(GeneratedCad, CategoriesWithoutSpecificationAreLeftOut) {
  WriteInstances("table-0001,table,0,1.2,0.7,0.6,a\nsofa-0001,sofa,0,2,1,1,b\n");
  EXPECT_TRUE(EdgesOfTable("table-0001", {1.2, 0.7, 0.6}));
}

TEST_F(GeneratedCad, BadInput) {
  WriteInstances("table-0001,table,0,1.2,-0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "size"});
  WriteInstances("table-0001,table,yes,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "held_out", "yes"});
  WriteInstances("table-0001,table,2,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "held_out", "2"});
  WriteInstances("table-0001,table,0,1.2,0.7,0.6,a\ntable-0001,table,0,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:3", "table-0001", "twice"});
  WriteInstances("table-0010,table,0,1.2,0.7,0.6,a\n");
  ExpectRefused({"instances.csv:2", "table-0010", "table_edges.csv"});
  WriteInstances("laptop-0001,laptop,0,0.3,0.2,0.2,a\n");
  ExpectRefused({"laptop_edges.csv"});
  folder_.Write("instances.csv", "id,category\ntable-0001,table\n");
  ExpectRefused({"instances.csv:1", "held_out"});
}

}  // namespace
}  // namespace armature
