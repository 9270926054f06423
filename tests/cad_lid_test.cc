// SPDX-License-Identifier: BSD-3-Clause
// Laptops opened differently from their models.
#include <gtest/gtest.h>

#include "datasets/cad/edge_ends.h"
#include "datasets/cad/laptop.h"
#include "datasets/cad/lid.h"
#include "datasets/cad/materials.h"
#include "datasets/cad/solids.h"

namespace armature {
namespace {

using Eigen::Vector3d;

// 0.4 wide, base and lid 0.3 deep and 0.02 thick, open by 90 degrees, its hinge at the origin.
CadInstance SquareLaptop() {
  CadInstance laptop;
  laptop.category = "laptop";
  LaptopParameters p;
  p.width = 0.4, p.depth = 0.3, p.lid_height = 0.3, p.lid_angle_deg = 90;
  laptop.wireframe = LaptopWireframe(p);
  const Part base = Block(Eigen::Isometry3d(Eigen::Translation3d(0, -0.01, 0.15)), {0.4, 0.02, 0.3}, {});
  const Part lid = Block(Eigen::Isometry3d(Eigen::Translation3d(0, 0.15, -0.01)), {0.4, 0.3, 0.02}, {});
  laptop.mesh.parts = {base, lid};
  const Eigen::AlignedBox3d box = BoundingBox(laptop.mesh);
  laptop.mesh = Shifted(laptop.mesh, -box.center());
  laptop.wireframe = Shifted(laptop.wireframe, -box.center());
  laptop.size = box.sizes();
  return laptop;
}

double Flatness(const Quad& quad) {
  const auto& [a, b, c, d] = quad.corners;
  return std::abs((b - a).cross(c - a).normalized().dot(d - a));
}

TEST(WithLid, OpensByTheAngle) {
  for (const double degrees : {60.0, 85.0, 90.0, 130.0}) {
    const CadInstance laptop = WithLid(SquareLaptop(), degrees);
    EXPECT_NEAR(LidAngle(laptop.wireframe), degrees, 1e-9);
    EXPECT_EQ(laptop.lid_deg, degrees);
  }
}

TEST(WithLid, TurnsTheLidAloneAboutTheHinge) {
  const CadInstance laptop = WithLid(SquareLaptop(), 120);
  // The lid's front leans back by 30 degrees; its back, 0.02 behind, reaches furthest.
  EXPECT_NEAR(laptop.size.x(), 0.4, 1e-12);
  EXPECT_NEAR(laptop.size.y(), 0.02 + 0.3 * std::cos(M_PI / 6), 1e-12);
  EXPECT_NEAR(laptop.size.z(), 0.3 + 0.3 * std::sin(M_PI / 6) + 0.02 * std::cos(M_PI / 6), 1e-12);
  EXPECT_TRUE(BoundingBox(laptop.mesh).center().isZero(1e-12)) << "centred again";
  // The hinge is where base and lid meet, at the height of the base's upper side.
  EXPECT_NEAR(laptop.wireframe.midpoints(1, 2), 0.02 - laptop.size.y() / 2, 1e-12);
  EXPECT_NEAR(laptop.wireframe.midpoints(2, 2), laptop.size.z() / 2 - 0.3, 1e-12);
}

TEST(WithLid, LeavesFlatFaces) {
  CadInstance laptop = SquareLaptop();
  // One solid, as published models are: a face in the plane of the hinge, one corner of which is the lid's.
  Part joined = laptop.mesh.parts[0];
  joined.quads.insert(joined.quads.end(), laptop.mesh.parts[1].quads.begin(),
                      laptop.mesh.parts[1].quads.end());
  const double rear = 0.02 - 0.5 * laptop.size.z(), low = -0.5 * laptop.size.y();
  joined.quads.push_back({{Vector3d(0.2, low, rear), Vector3d(-0.2, low, rear),
                           Vector3d(-0.2, low + 0.32, rear), Vector3d(0.2, low + 0.02, rear)}});
  laptop.mesh.parts = {joined};
  const CadInstance open = WithLid(laptop, 110);
  EXPECT_EQ(open.mesh.parts[0].quads.size(), joined.quads.size() + 1) << "the face in two triangles";
  for (const Quad& quad : open.mesh.parts[0].quads) EXPECT_LT(Flatness(quad), 1e-9);
}

TEST(WithLid, OfTheFamilyIsTheMemberThatWasBuiltSo) {
  LaptopParameters p = SampleLaptopFamily(1, 5).front();
  CadInstance laptop;
  laptop.mesh = LaptopMesh(p, {});
  laptop.wireframe = LaptopWireframe(p);
  laptop.size = BoundingBox(laptop.mesh).sizes();
  p.lid_angle_deg = 95;
  EXPECT_TRUE(WithLid(laptop, 95).size.isApprox(BoundingBox(LaptopMesh(p, {})).sizes(), 1e-9));
}

}  // namespace
}  // namespace armature
