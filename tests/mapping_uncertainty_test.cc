// SPDX-License-Identifier: BSD-3-Clause
// What the map says of how sure it is, against answers known by hand.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "mapping/map_solver.h"
#include "mapping/object_uncertainty.h"
#include "support/category_examples.h"

namespace armature {
namespace {

constexpr double kUnknownShape = 1e-4;  // shape weight: next to none

// One held camera that sees one object where it is, with these standard deviations of pose and shape.
struct OneView {
  CategoryModel model = testing::FrameModel();
  MapGraph graph;

  explicit OneView(const Eigen::VectorXd& sigmas) {
    graph.cameras_are_held = graph.scale_is_held = true;
    graph.T_world_camera.push_back(Eigen::Isometry3d::Identity());
    GraphObject& object = graph.objects.emplace_back();
    object.model = &model;
    object.coefficients = Eigen::VectorXd::Zero(model.modes());
    object.T_world_object.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
    object.T_world_object.translation() << 0, 0, 2;
    ObjectFactor& factor = graph.observations.emplace_back();
    factor.at = {object.T_world_object, object.coefficients};
    factor.A = sigmas.cwiseInverse().asDiagonal();
    factor.b = Eigen::VectorXd::Zero(sigmas.size());
  }
};

Eigen::VectorXd Sigmas() {
  Eigen::VectorXd sigmas(9);
  sigmas << 0.01, 0.02, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  return sigmas;
}

MapSolverOptions ViewAlone() {
  MapSolverOptions options;
  options.shape_weight = kUnknownShape;
  options.upright_sigma_deg = options.floor_sigma = 0;
  return options;
}

TEST(GraphUncertainty, OfOneViewIsThatOfTheView) {
  const OneView world(Sigmas());
  const auto uncertainty = ComputeUncertainty(world.graph, ViewAlone());
  ASSERT_TRUE(uncertainty);
  EXPECT_FALSE(uncertainty->scale_sigma);  // it is held
  ASSERT_EQ(uncertainty->objects.size(), 1u);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(10, 10);  // the size is held
  expected.diagonal().head(9) = Sigmas().cwiseAbs2();
  EXPECT_LT((uncertainty->objects[0] - expected).norm(), 1e-6);
}

TEST(GraphUncertainty, HalvesItsVarianceWithASecondViewThatIsAlike) {
  OneView world(Sigmas());
  world.graph.observations.push_back(world.graph.observations.front());
  const auto uncertainty = ComputeUncertainty(world.graph, ViewAlone());
  ASSERT_TRUE(uncertainty);
  EXPECT_NEAR(uncertainty->objects[0](5, 5), 0.3 * 0.3 / 2, 1e-6);
}

TEST(GraphUncertainty, IsNoneWhereAnObjectIsNotDetermined) {
  OneView world(Sigmas());
  world.graph.observations.front().A.row(5).setZero();  // nobody knows how far along its z axis it is
  EXPECT_FALSE(ComputeUncertainty(world.graph, ViewAlone()));
}

// The object's z axis is the world's x. At a probability of 0.8 the odds against are 1/4, their root is 1/2.
TEST(CovarianceOfPoseAndSize, IsAlongTheWorldsAxesAndWiderTheLessProbableTheObject) {
  const OneView world(Sigmas());
  Eigen::MatrixXd unknowns = Eigen::MatrixXd::Zero(10, 10);
  unknowns.diagonal().head(6) = Sigmas().head(6).cwiseAbs2();
  unknowns(9, 9) = 0.01 * 0.01;  // of the size's logarithm
  const GraphObject& object = world.graph.objects[0];
  const PoseAndSizeCovariance covariance = CovarianceOfPoseAndSize(object, unknowns, 0.8);
  const double rotation = 0.9 + 1.6 / 2, translation = 1.0 + 2.3 / 2, size = 2.1 + 1.6 / 2;
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 0.03 * rotation, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), 0.02 * rotation, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(2, 2)), 0.01 * rotation, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(3, 3)), 0.3 * translation, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(4, 4)), 0.2 * translation, 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(5, 5)), 0.1 * translation, 1e-12);
  const Eigen::Vector3d extent =
      BoundingBoxSize(WireframeFromCoefficients(world.model, object.coefficients)) +
      2 * world.model.spec.padding;
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(std::sqrt(covariance(6 + axis, 6 + axis)), 0.01 * extent(axis) * size, 1e-12);
  EXPECT_EQ(covariance, covariance.transpose());
  const PoseAndSizeCovariance surer = CovarianceOfPoseAndSize(object, unknowns, 0.99);
  EXPECT_LT(surer.trace(), 0.5 * covariance.trace());
}

TEST(WidenScaleSigma, GoesByTheMeanOddsAgainstTheObjects) {
  EXPECT_NEAR(WidenScaleSigma(0.01, {0.8, 0.8}), 0.01 * (1.0 + 2.3 / 2), 1e-12);
  EXPECT_NEAR(WidenScaleSigma(0.01, {1, 2.0 / 3}), 0.01 * (1.0 + 2.3 / 2), 1e-12);  // odds of 0 and 1/2
}

}  // namespace
}  // namespace armature
