// SPDX-License-Identifier: BSD-3-Clause
// CAD models fitted to perfect views of a chair of known shape.
#include <gtest/gtest.h>

#include "support/seen_chair.h"

namespace armature {
namespace {

using testing::FewCentimetres;
using testing::SeenChair;

Wireframe Scaled(double scale, const Wireframe& wireframe) {
  return {scale * wireframe.midpoints, scale * wireframe.directions};
}

InstanceFit FitTo(const SeenChair& chair, const Wireframe& wireframe, double size_sigma = 0,
                  const InstanceFitOptions& options = {}) {
  return FitInstance(chair.Sightings(FewCentimetres()), chair.model().spec, wireframe, size_sigma, options);
}

double MetresOff(const SeenChair& chair, const InstanceFit& fit) {
  return (fit.T_world_object.translation() - chair.truth().T_world_object.translation()).norm();
}

double DegreesOff(const SeenChair& chair, const InstanceFit& fit) {
  const Eigen::AngleAxisd off(fit.T_world_object.linear().transpose() *
                              chair.truth().T_world_object.linear());
  return off.angle() / kDegree;
}

TEST(MakeInstanceModel, HasItsSizeAsItsOnlyMode) {
  const SeenChair chair;
  const Wireframe wireframe = chair.TrueWireframe();
  const CategoryModel model = MakeInstanceModel(chair.model().spec, wireframe, 0.05);
  ASSERT_EQ(model.modes(), 1);
  EXPECT_NEAR(model.basis.norm(), 1, 1e-12);
  const Wireframe larger = WireframeFromCoefficients(model, Eigen::VectorXd::Constant(1, 2));
  EXPECT_TRUE(ShapeVector(larger).isApprox(1.1 * ShapeVector(wireframe)));
}

TEST(FitInstance, TheTrueInstanceIsFoundWhereItIs) {
  const SeenChair chair;
  const InstanceFit fit = FitTo(chair, chair.TrueWireframe());
  EXPECT_LT(MetresOff(chair, fit), 0.01);
  EXPECT_LT(DegreesOff(chair, fit), 0.5);
  EXPECT_NEAR(fit.scale, 1, 0.01);
}

TEST(FitInstance, TheTrueInstanceCostsLeast) {
  const SeenChair chair;
  const double cost = FitTo(chair, chair.TrueWireframe()).cost;
  for (Eigen::Index mode = 0; mode < 5; ++mode) {
    for (const double off : {-0.7, 0.7}) {
      Eigen::VectorXd coefficients = chair.truth().coefficients;
      coefficients(mode) += off;
      EXPECT_GT(FitTo(chair, WireframeFromCoefficients(chair.model(), coefficients)).cost, cost + 0.02)
          << "mode " << mode << " off by " << off;
    }
  }
}

// Its depth and its size are two things where cameras go around it.
TEST(FitInstance, AnInstanceOfUnknownSizeFindsIt) {
  const SeenChair chair;
  for (const double too_large : {1.04, 0.96}) {
    const InstanceFit fit = FitTo(chair, Scaled(too_large, chair.TrueWireframe()), 0.05);
    EXPECT_NEAR(fit.scale * too_large, 1, 0.01);
    EXPECT_LT(MetresOff(chair, fit), 0.015);
  }
}

TEST(FitInstance, AnInstanceOfKnownSizeKeepsIt) {
  const SeenChair chair;
  InstanceFitOptions held;
  held.size_sigma = 0;
  const Wireframe large = Scaled(1.04, chair.TrueWireframe());
  EXPECT_EQ(FitTo(chair, large, 0, held).scale, 1);
  EXPECT_GT(FitTo(chair, large, 0, held).cost, FitTo(chair, large, 0.05, held).cost);
}

// Eight images tell the size to about one percent: less than that holds it, more does not.
TEST(FitInstance, TheSizesPriorIsAsWideAsItSays) {
  const SeenChair chair;
  const Wireframe large = Scaled(1.04, chair.TrueWireframe());
  InstanceFitOptions options;
  const auto scale_with = [&](double of_instance, double of_map) {
    options.size_sigma = of_map;
    return FitTo(chair, large, of_instance, options).scale;
  };
  EXPECT_GT(scale_with(0.002, 0), 0.998);
  EXPECT_NEAR(scale_with(0.01, 0), 0.98, 0.006);
  EXPECT_LT(scale_with(0.05, 0), 0.965);
  EXPECT_EQ(scale_with(0.003, 0.004), scale_with(0, 0.005)) << "map and instance err independently";
}

TEST(FitInstance, WithoutRoundsItIsMeasuredWhereTheMapHasIt) {
  const SeenChair chair;
  InstanceFitOptions options;
  options.refinement.rounds = 0;
  const ObjectSightings there = chair.Sightings(), beside = chair.Sightings(FewCentimetres());
  const InstanceFit fit = FitInstance(there, chair.model().spec, chair.TrueWireframe(), 0, options);
  EXPECT_TRUE(fit.T_world_object.isApprox(there.T_world_object));
  EXPECT_EQ(fit.scale, 1);
  EXPECT_GT(FitInstance(beside, chair.model().spec, chair.TrueWireframe(), 0, options).cost, fit.cost + 1);
}

TEST(FitInstance, TheSameAgain) {
  const SeenChair chair;
  const InstanceFit a = FitTo(chair, chair.TrueWireframe()), b = FitTo(chair, chair.TrueWireframe());
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.T_world_object.matrix(), b.T_world_object.matrix());
}

}  // namespace
}  // namespace armature
