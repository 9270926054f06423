// SPDX-License-Identifier: BSD-3-Clause
// Collections on disk as furniture.
#include <gtest/gtest.h>

#include "category/kept_apart.h"
#include "datasets/cad/collection_files.h"
#include "datasets/cad/folder_collection.h"
#include "datasets/cad/published_meshes.h"
#include "datasets/cad/resized.h"
#include "geometry/mesh_shapes.h"
#include "support/expect_input_error.h"
#include "support/published_chairs.h"

namespace armature {
namespace {

using Eigen::Vector3d;
using testing::ExpectInputError;
using testing::PublishedId;
using testing::TempFolder;

TEST(FolderCollection, BringsPublishedChairsToTheirUsualSeat) {
  const TempFolder folder;
  testing::WritePublishedChairs(folder, {PublishedId(true)});
  const std::vector<CadInstance> chairs = ReadFolderCollection(folder.path(), FurnitureSpecs());
  ASSERT_EQ(chairs.size(), 1U);
  const CadInstance chair = Loaded(chairs[0]);
  EXPECT_EQ(chair.collection, "keypointnet");
  EXPECT_EQ(chair.prefix + chair.id, "keypointnet:" + PublishedId(true));
  EXPECT_TRUE(chair.size.isApprox(Vector3d(0.5, 0.9, 0.5), 1e-9));  // the seat at 0.45 m
  EXPECT_EQ(chair.mesh.parts.size(), 6U);
  EXPECT_TRUE(BoundingBox(chair.mesh).center().isZero(1e-9));
  EXPECT_NEAR(chair.wireframe.midpoints(1, 3), 0, 1e-9);      // the seat, in the middle of the height
  EXPECT_NEAR(chair.wireframe.midpoints(2, 0), -0.25, 1e-9);  // the back is at the rear
  for (const Part& part : chair.mesh.parts) {
    const Vector3d size = BoundingBox({{part}}).sizes();
    EXPECT_GT(size.minCoeff(), 0.04);
  }
}

TEST(FolderCollection, HoldsOutThoseThatLearningLeavesOut) {
  const TempFolder folder;
  testing::WritePublishedChairs(folder, {PublishedId(true), PublishedId(false)});
  for (const CadInstance& chair : ReadFolderCollection(folder.path(), FurnitureSpecs()))
    EXPECT_EQ(chair.held_out, chair.id == PublishedId(true)) << chair.id;
}

TEST(FolderCollection, KeepsAFifthApart) {
  int kept = 0;
  for (int i = 0; i < 1000; ++i) kept += IsKeptApart(std::to_string(i)) ? 1 : 0;
  EXPECT_NEAR(kept, 200, 50);
  static_assert(IsKeptApart("") == (14695981039346656037ULL % 5 == 0));
}

TEST(FolderCollection, ReadsItsOwnModelsAsTheyAre) {
  const TempFolder folder;
  const std::vector<CadInstance> own = DrawCollection({.chairs = 10, .tables = 1, .laptops = 1});
  WriteCollection(own, folder.path());
  const std::vector<CadInstance> read = ReadFolderCollection(folder.path(), FurnitureSpecs());
  ASSERT_EQ(read.size(), own.size());
  for (size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(read[i].id, own[i].id);
    EXPECT_EQ(read[i].prefix, "armature:");
    EXPECT_EQ(read[i].collection, folder.path().filename().string());
    EXPECT_EQ(read[i].held_out, own[i].held_out);
  }
  const CadInstance chair = Loaded(read[0]);
  EXPECT_TRUE(chair.size.isApprox(own[0].size, 1e-5));
  EXPECT_TRUE(chair.wireframe.midpoints.isApprox(own[0].wireframe.midpoints, 1e-5));
  EXPECT_GT(chair.mesh.parts.size(), 5U);  // legs, seat and back are apart, so that it fits under a table
}

TEST(FolderCollection, ReportsTwoOfOneName) {
  const TempFolder folder;
  testing::WritePublishedChairs(folder, {PublishedId(true)});
  ExpectInputError(
      [&] {
        CollectFurniture({}, {folder.path(), folder.path()});
      },
      {"--collection", "keypointnet", "leave one out"});
}

TEST(Resized, StretchesMeshAndEdges) {
  const CadInstance chair = DrawCollection({.chairs = 1, .tables = 0, .laptops = 0})[0];
  const Vector3d size(0.5, 1.1, 0.7);
  const CadInstance resized = Resized(chair, size);
  EXPECT_TRUE(BoundingBox(resized.mesh).sizes().isApprox(size, 1e-9));
  const Vector3d factors = size.cwiseQuotient(chair.size);
  EXPECT_TRUE(resized.wireframe.End(4, 1).isApprox(factors.cwiseProduct(chair.wireframe.End(4, 1)), 1e-9));
}

// Published meshes have triangles that face any way.
TEST(TriangleFurniture, TurnsTrianglesOutwardsAndTakesPiecesApart) {
  TriangleMesh mesh = BoxMesh({0, 0, 0}, 0.2 * Eigen::Matrix3d::Identity());
  Append(BoxMesh({1, 0, 0}, 0.1 * Eigen::Matrix3d::Identity()), {0, 0, 0}, mesh);
  mesh.colours.resize(3, 0);
  for (Eigen::Index t = 0; t < mesh.size(); t += 2) std::swap(mesh.triangles(1, t), mesh.triangles(2, t));
  const Mesh furniture = TriangleFurniture(mesh, DrawFurnitureMaterials("laptop", 1));
  ASSERT_EQ(furniture.parts.size(), 2U);
  for (const Part& part : furniture.parts) {
    const Vector3d centre = BoundingBox({{part}}).center();
    for (const Quad& quad : part.quads) {
      const auto& c = quad.corners;
      EXPECT_GT((c[1] - c[0]).cross(c[2] - c[0]).dot(c[0] - centre), 0);
    }
  }
}

}  // namespace
}  // namespace armature
