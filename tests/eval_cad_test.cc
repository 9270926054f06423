// SPDX-License-Identifier: BSD-3-Clause
// The CAD models that `armature generate` writes, as the evaluation reads them.
#include <gtest/gtest.h>

#include "support/small_cad.h"
#include "support/true_world.h"

namespace armature {
namespace {

class GeneratedCad : public ::testing::Test {
 protected:
  GeneratedCad() { testing::WriteSmallCad(folder_, FindSpec(specs_, "table")); }
  std::optional<Wireframe> EdgesOfTable(const std::string& id, const Eigen::Vector3d& size) const {
    TrueObject object{"table0", "table", "armature:" + id};
    object.size = size;
    return CadLibrary(folder_.path(), specs_).FindEdges(object);
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

TEST_F(GeneratedCad, OtherInstancesAreNotKnown) { EXPECT_FALSE(EdgesOfTable("table-0002", {2, 0.7, 0.6})); }

}  // namespace
}  // namespace armature
