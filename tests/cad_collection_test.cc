// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "category/normalise.h"
#include "datasets/cad/cad_instance.h"
#include "datasets/cad/collection_files.h"
#include "io/category_yaml.h"
#include "support/category_examples.h"
#include "support/part_volume.h"

namespace armature {
namespace {

using Eigen::Vector3d;

const std::vector<CadInstance>& Collection() {
  static const std::vector<CadInstance> collection = DrawCollection({60, 40, 40, 5});
  return collection;
}

int Edge(const CadInstance& instance, const std::string& name) {
  const std::vector<std::string> names = EdgeNames(instance.category);
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

// Of the point from a triangle's nearest point (Ericson 2004, 5.1.5).
double TriangleDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto along = [&](const Vector3d& from, const Vector3d& to) {
    const Vector3d side = to - from;
    const double share = std::clamp((p - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
    return (p - from - share * side).norm();
  };
  const Vector3d normal = (b - a).cross(c - a);
  const bool is_above = normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                        normal.dot((a - c).cross(p - c)) >= 0;
  if (is_above) return std::abs(normal.normalized().dot(p - a));
  return std::min({along(a, b), along(b, c), along(c, a)});
}

double Distance(const Vector3d& point, const Mesh& mesh) {
  double nearest = 1e9;
  for (const Part& part : mesh.parts) {
    for (const Quad& quad : part.quads) {
      const auto& [a, b, c, d] = quad.corners;
      nearest = std::min(nearest, TriangleDistance(point, a, b, c));
      if (c != d) nearest = std::min(nearest, TriangleDistance(point, a, c, d));
    }
  }
  return nearest;
}

TEST(Collection, PartsAreClosedSolids) {
  for (const CadInstance& instance : Collection()) {
    for (const Part& part : instance.mesh.parts) {
      EXPECT_TRUE(testing::IsClosed(part)) << instance.id;
      EXPECT_GT(testing::Volume(part), 1e-9) << instance.id;
    }
  }
}

TEST(Collection, QuadsAreFlat) {
  for (const CadInstance& instance : Collection()) {
    for (const Part& part : instance.mesh.parts) {
      for (const Quad& quad : part.quads) {
        const auto& [a, b, c, d] = quad.corners;
        const Vector3d normal = (b - a).cross(c - a).normalized();
        EXPECT_LT(std::abs(normal.dot(d - a)), 0.002) << instance.id;
      }
    }
  }
}

TEST(Collection, MeshesAreCentredAndOfTheirSize) {
  for (const CadInstance& instance : Collection()) {
    const Eigen::AlignedBox3d box = BoundingBox(instance.mesh);
    EXPECT_LT(box.center().norm(), 1e-12) << instance.id;
    EXPECT_LT((box.sizes() - instance.size).norm(), 1e-12) << instance.id;
  }
}

TEST(Collection, EdgesEndOnTheMeshAndLieAlongIt) {
  for (const CadInstance& instance : Collection()) {
    const Wireframe& wireframe = instance.wireframe;
    for (int edge = 0; edge < wireframe.edges(); ++edge) {
      for (const int end : {0, 1}) {
        EXPECT_LT(Distance(wireframe.End(edge, end), instance.mesh), 0.025) << instance.id << " " << edge;
      }
      EXPECT_LT(Distance(wireframe.midpoints.col(edge), instance.mesh), 0.05) << instance.id << " " << edge;
    }
  }
}

TEST(Collection, WireframesAreNearlyAsLargeAsTheirMeshes) {
  for (const CadInstance& instance : Collection()) {
    const Vector3d beyond = instance.size - BoundingBoxSize(instance.wireframe);
    EXPECT_GE(beyond.minCoeff(), -1e-12) << instance.id;
    EXPECT_LT(beyond.y(), 0.03) << instance.id;
    if (instance.category == "chair") continue;          // armrests reach beyond the wireframe
    EXPECT_LT(beyond.maxCoeff(), 0.085) << instance.id;  // splayed feet, thickest leg
  }
}

TEST(Collection, EdgesHaveTheSenseOfTheSpecification) {
  for (const CadInstance& instance : Collection()) {
    const Wireframe& w = instance.wireframe;
    const CategorySpec spec =
        LoadCategorySpec(testing::CategoryFolder() / "specs" / (instance.category + ".yaml"));
    ASSERT_EQ(spec.edge_names, EdgeNames(instance.category));
    const Vector3d first = w.directions.col(spec.base_edges[0]),
                   second = w.directions.col(spec.base_edges[1]);
    EXPECT_GT(first.cross(second).normalized().y(), 0.9) << instance.id;
    if (instance.category != "chair") continue;
    for (const char* name : {"back_top", "seat_rear", "seat_front"}) {
      EXPECT_GT(w.directions(0, Edge(instance, name)), 0.2);
    }
    for (const char* name : {"back_left", "leg_front_left", "leg_rear_left", "leg_rear_right"}) {
      EXPECT_LT(w.directions(1, Edge(instance, name)), -0.1);
    }
    EXPECT_GT(w.directions(2, Edge(instance, "seat_left")), 0.2);
    EXPECT_LT(w.midpoints(0, Edge(instance, "leg_rear_left")), 0);
    EXPECT_LT(w.midpoints(2, Edge(instance, "back_top")), w.midpoints(2, Edge(instance, "seat_front")));
  }
}

TEST(Collection, FourFeetStandOnTheFloor) {
  for (const CadInstance& instance : Collection()) {
    if (instance.category == "laptop") continue;
    std::set<std::pair<bool, bool>> corners;  // left or right, rear or front
    for (const Part& part : instance.mesh.parts) {
      const Eigen::AlignedBox3d box = BoundingBox(Mesh{{part}});
      if (box.min().y() < -0.5 * instance.size.y() + 1e-9) {
        corners.insert({box.center().x() < 0, box.center().z() < 0});
      }
    }
    EXPECT_EQ(corners.size(), 4u) << instance.id;
  }
}

TEST(Collection, IdsCountFromOneAndEveryTenthIsHeldOut) {
  EXPECT_EQ(Collection().size(), 140u);
  EXPECT_EQ(Collection()[0].id, "chair-0001");
  EXPECT_EQ(Collection()[60].id, "table-0001");
  EXPECT_EQ(Collection()[139].id, "laptop-0040");
  EXPECT_FALSE(Collection()[8].held_out);
  EXPECT_TRUE(Collection()[9].held_out);
  EXPECT_EQ(std::count_if(Collection().begin(), Collection().end(), [](const auto& i) { return i.held_out; }),
            14);
}

TEST(Collection, NoTwoModelsHaveOneShape) {
  std::set<std::string> shapes;
  for (const CadInstance& instance : Collection()) {
    const Eigen::VectorXd shape = ShapeVector(instance.wireframe);
    shapes.insert(std::string(reinterpret_cast<const char*>(shape.data()), sizeof(double) * 42));
  }
  EXPECT_EQ(shapes.size(), Collection().size());
}

TEST(Collection, TheFirstOnesDoNotDependOnTheCounts) {
  const std::vector<CadInstance> fewer = DrawCollection({7, 5, 3, 5}), other = DrawCollection({7, 5, 3, 6});
  const auto index = [](int i) { return static_cast<size_t>(i < 7 ? i : i < 12 ? i + 53 : i + 88); };
  for (int i = 0; i < 15; ++i) {
    const CadInstance &a = fewer[static_cast<size_t>(i)], &b = Collection()[index(i)];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(CadPlyText(a.mesh), CadPlyText(b.mesh)) << a.id;
    EXPECT_NE(CadPlyText(a.mesh), CadPlyText(other[static_cast<size_t>(i)].mesh)) << a.id;
  }
}

}  // namespace
}  // namespace armature
