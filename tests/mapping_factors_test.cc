// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/rotation.h"
#include "geometry/se3.h"
#include "mapping/map_factors.h"
#include "mapping/pose_block.h"
#include "mapping/supports.h"
#include "resection/resection_problem.h"
#include "support/map_world.h"

namespace armature {
namespace {

using testing::LoadModel;

// The values of a parameter block; a pose moves along its manifold. (A shape can have 7 numbers as well.)
struct Block : std::vector<double> {
  using std::vector<double>::vector;
  bool is_pose = false;
};

Eigen::Isometry3d Pose(const Eigen::Vector3d& w, const Eigen::Vector3d& t) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = ExpSO3(w);
  pose.translation() = t;
  return pose;
}

Block BlockOf(const Eigen::Isometry3d& pose) {
  const auto values = ToBlock(pose);
  Block block(values.data(), values.data() + values.size());
  block.is_pose = true;
  return block;
}

Block BlockOf(const Eigen::VectorXd& values) { return Block(values.data(), values.data() + values.size()); }

Eigen::VectorXd Residuals(const ceres::CostFunction& cost, const std::vector<Block>& blocks) {
  std::vector<const double*> parameters;
  for (const Block& block : blocks) parameters.push_back(block.data());
  Eigen::VectorXd residuals(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(parameters.data(), residuals.data(), nullptr));
  return residuals;
}

// The block moved by `size` along its i-th tangent direction.
Block Stepped(const Block& block, int i, double size) {
  Block stepped = block;
  if (block.is_pose) {
    const Vector6d delta = size * Vector6d::Unit(i);
    PoseManifold().Plus(block.data(), delta.data(), stepped.data());
  } else {
    stepped[static_cast<size_t>(i)] += size;
  }
  return stepped;
}

Eigen::MatrixXd JacobianByDifferences(const ceres::CostFunction& cost, const std::vector<Block>& blocks,
                                      size_t of) {
  const double h = 1e-6;
  const int size = blocks[of].is_pose ? 6 : static_cast<int>(blocks[of].size());
  Eigen::MatrixXd J(cost.num_residuals(), size);
  for (int i = 0; i < size; ++i) {
    std::vector<Block> ahead = blocks, behind = blocks;
    ahead[of] = Stepped(blocks[of], i, h);
    behind[of] = Stepped(blocks[of], i, -h);
    J.col(i) = (Residuals(cost, ahead) - Residuals(cost, behind)) / (2 * h);
  }
  return J;
}

// What Ceres makes of the cost's Jacobian: by the manifold's tangent.
Eigen::MatrixXd AnalyticJacobian(const ceres::CostFunction& cost, const std::vector<Block>& blocks,
                                 size_t of) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<const double*> parameters;
  for (const Block& block : blocks) parameters.push_back(block.data());
  std::vector<double> values(static_cast<size_t>(cost.num_residuals()) * blocks[of].size());
  std::vector<double*> jacobians(blocks.size(), nullptr);  // the others are held
  jacobians[of] = values.data();
  Eigen::VectorXd residuals(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(parameters.data(), residuals.data(), jacobians.data()));
  const RowMajor J =
      Eigen::Map<RowMajor>(values.data(), cost.num_residuals(), static_cast<Eigen::Index>(blocks[of].size()));
  if (!blocks[of].is_pose) return J;
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  PoseManifold().PlusJacobian(blocks[of].data(), plus.data());
  return J * plus;
}

void ExpectJacobians(const ceres::CostFunction& cost, const std::vector<Block>& blocks) {
  ASSERT_EQ(cost.parameter_block_sizes().size(), blocks.size());
  for (size_t of = 0; of < blocks.size(); ++of) {
    ASSERT_EQ(cost.parameter_block_sizes()[of], static_cast<int>(blocks[of].size()));
    const Eigen::MatrixXd expected = JacobianByDifferences(cost, blocks, of);
    const Eigen::MatrixXd J = AnalyticJacobian(cost, blocks, of);
    EXPECT_GT(expected.norm(), 0) << "block " << of;
    EXPECT_LT((J - expected).norm(), 1e-6 * (1 + expected.norm())) << "block " << of << "\n"
                                                                   << J << "\nexpected\n"
                                                                   << expected;
  }
}

const Eigen::Isometry3d kPoseA = Pose({0.3, -1.2, 0.7}, {5, -0.2, 1});
const Eigen::Isometry3d kPoseB = Pose({-0.4, 0.5, 2.0}, {4, 1.3, 2});

// --- The manifold of poses (more in mapping_pose_block_test.cc)

TEST(PoseManifold, PlusUndoesMinus) {
  const Block x = BlockOf(kPoseA), y = BlockOf(kPoseB);
  Vector6d delta;
  Block reached(7);
  PoseManifold().Minus(y.data(), x.data(), delta.data());
  PoseManifold().Plus(x.data(), delta.data(), reached.data());
  EXPECT_TRUE(FromBlock(reached.data()).isApprox(kPoseB, 1e-9));
}

TEST(PoseManifold, BothSignsOfAQuaternionAreOnePose) {
  Block x = BlockOf(kPoseA), negated = x;
  for (size_t i = 3; i < 7; ++i) negated[i] = -x[i];
  Vector6d delta;
  PoseManifold().Minus(negated.data(), x.data(), delta.data());
  EXPECT_LT(delta.norm(), 1e-9);
}

TEST(PoseManifold, DerivativesOfPlusAndMinusAreInverse) {
  const Block x = BlockOf(kPoseA);
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> minus;
  PoseManifold().PlusJacobian(x.data(), plus.data());
  PoseManifold().MinusJacobian(x.data(), minus.data());
  EXPECT_TRUE((minus * plus).isIdentity(1e-12));
}

// --- Odometry

OdometryFactor Step(const Eigen::Isometry3d& T_from_to, double share) {
  OdometryFactor factor;
  factor.T_from_to = T_from_to;
  factor.rotation_sigma = 0.1;
  factor.translation_sigma = 0.5;
  factor.share = share;
  return factor;
}

TEST(OdometryCost, DerivativesAgreeWithDifferences) {
  // Far from the measured step, and near to it.
  const Eigen::Isometry3d Z = kPoseA.inverse() * kPoseB * Pose({0.2, -0.1, 0.3}, {0.3, 0.2, 0.1});
  ExpectJacobians(OdometryCost(Step(Z, 0.3)), {BlockOf(kPoseA), BlockOf(kPoseB), {0.4}, {0.9}});
  ExpectJacobians(OdometryCost(Step(Z, 0.3)), {BlockOf(kPoseA), BlockOf(kPoseB), {0.0}, {0.001}});
}

TEST(OdometryCost, TheMeasuredStepTimesTheScaleCostsNothing) {
  const double scale = 2.65;
  Eigen::Isometry3d Z = kPoseA.inverse() * kPoseB;
  Z.translation() /= scale;
  const Block s{std::log(scale)};
  EXPECT_LT(Residuals(OdometryCost(Step(Z, 0.7)), {BlockOf(kPoseA), BlockOf(kPoseB), s, s}).norm(), 1e-9);
}

// 1 unit ahead at 2 m a unit where the cameras are 3 m apart: 1 m too far, in standard deviations of 0.5 m.
TEST(OdometryCost, IsInStandardDeviationsAndInTheFirstCamerasAxes) {
  const Eigen::Isometry3d quarter = Pose({0, 0, M_PI / 2}, {7, 0, 0});  // its x axis is the world's y
  const Eigen::Isometry3d ahead = Pose({0, 0, M_PI / 2}, {7, 3, 0});
  const OdometryCost cost(Step(Pose({0, 0, 0}, {1, 0, 0}), 0.5));
  const Block s{std::log(2.0)};
  Vector6d expected;
  expected << 0, 0, 0, 2, 0, 0;
  EXPECT_LT((Residuals(cost, {BlockOf(quarter), BlockOf(ahead), s, s}) - expected).norm(), 1e-9);
  // Turned by 0.05 rad about its own axis instead: half a standard deviation of rotation.
  const OdometryCost still(Step(Eigen::Isometry3d::Identity(), 0.5));
  expected << 0, 0, 0.5, 0, 0, 0;
  const Block turned = BlockOf(quarter * Pose({0, 0, 0.05}, {0, 0, 0}));
  EXPECT_LT((Residuals(still, {BlockOf(quarter), turned, s, s}) - expected).norm(), 1e-9);
}

// A quarter of the way from 2 to 32 on a logarithmic scale: 2 * 16^(1/4) = 4.
TEST(OdometryCost, InterpolatesTheLogarithmOfTheScale) {
  const OdometryCost cost(Step(Pose({0, 0, 0}, {1, 0, 0}), 0.25));
  const Eigen::VectorXd r = Residuals(cost, {BlockOf(Pose({0, 0, 0}, {0, 0, 0})),
                                             BlockOf(Pose({0, 0, 0}, {4, 0, 0})),
                                             {std::log(2.0)},
                                             {std::log(32.0)}});
  EXPECT_LT(r.norm(), 1e-9);
}

// --- Objects in images

ObjectFactor ExampleFactor(int modes) {
  ObjectFactor factor;
  factor.at.T_camera_object = Pose({0.2, 2.1, -0.3}, {0.4, 0.3, 2.5});
  factor.at.coefficients = Eigen::VectorXd::LinSpaced(modes, -0.5, 0.8);
  const int size = 6 + modes;
  factor.A = Eigen::MatrixXd::Identity(size, size);
  for (int i = 0; i < size; ++i) {  // upper triangular, as of a Cholesky factor
    for (int j = i; j < size; ++j) factor.A(i, j) += 0.1 * std::sin(1.0 + 3.0 * i + 7.0 * j);
  }
  factor.b = Eigen::VectorXd::LinSpaced(size, 0.3, -0.6);
  return factor;
}

TEST(ObjectCost, DerivativesAgreeWithDifferences) {
  for (const int modes : {1, 5}) {
    const ObjectFactor factor = ExampleFactor(modes);
    const Eigen::Isometry3d object =
        kPoseA * factor.at.T_camera_object * Pose({0.3, -0.2, 0.4}, {0.2, 0, 0.5});
    const Eigen::VectorXd shape = factor.at.coefficients.array() + 0.7;
    ExpectJacobians(ObjectCost(factor), {BlockOf(kPoseA), BlockOf(object), BlockOf(shape), {-0.12}});
  }
}

TEST(ObjectCost, AtItsOwnPoseAndShapeItIsB) {
  const ObjectFactor factor = ExampleFactor(3);
  const Eigen::VectorXd r = Residuals(
      ObjectCost(factor),
      {BlockOf(kPoseA), BlockOf(kPoseA * factor.at.T_camera_object), BlockOf(factor.at.coefficients), {0.0}});
  EXPECT_LT((r - factor.b).norm(), 1e-9);
}

// The object 0.2 m farther along its own x axis and its second coefficient larger by 1.
TEST(ObjectCost, IsLinearInTheStepFromThere) {
  const ObjectFactor factor = ExampleFactor(3);
  const Eigen::Isometry3d object = kPoseA * factor.at.T_camera_object * Pose({0, 0, 0}, {0.2, 0, 0});
  const Eigen::VectorXd shape = factor.at.coefficients + Eigen::VectorXd::Unit(3, 1);
  const Eigen::VectorXd expected = factor.b + 0.2 * factor.A.col(3) + factor.A.col(7);
  const Eigen::VectorXd r =
      Residuals(ObjectCost(factor), {BlockOf(kPoseA), BlockOf(object), BlockOf(shape), {0.0}});
  EXPECT_LT((r - expected).norm(), 1e-9);
}

// Twice as large and twice as far away, it looks the same.
TEST(ObjectCost, SizeAndDistanceLookAlike) {
  const ObjectFactor factor = ExampleFactor(3);
  Eigen::Isometry3d farther = factor.at.T_camera_object;
  farther.translation() *= 2;
  const Eigen::VectorXd r = Residuals(
      ObjectCost(factor),
      {BlockOf(kPoseA), BlockOf(kPoseA * farther), BlockOf(factor.at.coefficients), {std::log(2.0)}});
  EXPECT_LT((r - factor.b).norm(), 1e-9);
}

// --- Upright and on the floor

TEST(UprightCost, DerivativesAgreeWithDifferences) {
  ExpectJacobians(UprightCost(0.02), {BlockOf(kPoseA), {0.1, -0.9, 0.3}});
}

TEST(UprightCost, IsTheDifferenceOfTheTwoDirections) {
  const UprightCost cost(0.5);
  const Block lying = BlockOf(Pose({M_PI / 2, 0, 0}, {1, 2, 3}));  // its y axis is the world's z
  const Eigen::VectorXd r = Residuals(cost, {lying, {0, 1, 0}});
  EXPECT_LT((r - Eigen::Vector3d(0, -2, 2)).norm(), 1e-9);
  EXPECT_LT(Residuals(cost, {lying, {0, 0, 1}}).norm(), 1e-9);
}

GraphObject ExampleObject(const CategoryModel& model) {
  GraphObject object{&model, Pose({3, 0.2, 0.1}, {1, 0.3, 2}), Eigen::VectorXd::Zero(model.modes())};
  object.coefficients.head<3>() << 0.5, -1, 0.7;
  return object;
}

double LowestY(const GraphObject& object) {
  const Wireframe wireframe = WireframeFromCoefficients(*object.model, object.coefficients);
  double lowest = 1e9;
  for (int edge = 0; edge < wireframe.edges(); ++edge) {
    lowest = std::min({lowest, wireframe.End(edge, 0).y(), wireframe.End(edge, 1).y()});
  }
  return lowest;
}

TEST(FloorCost, DerivativesAgreeWithDifferences) {
  const CategoryModel model = LoadModel("chair");
  const GraphObject object = ExampleObject(model);
  ExpectJacobians(
      FloorCost(object, 0.02),
      {BlockOf(object.T_world_object), BlockOf(object.coefficients), {0.2}, {0.1, -0.9, 0.3}, {-1.1}});
}

TEST(FloorCost, IsTheHeightOfTheLowestPointAboveTheFloor) {
  const CategoryModel model = LoadModel("table");
  GraphObject object = ExampleObject(model);
  object.T_world_object = Pose({0, 0.8, 0}, {3, 1.2, -2});
  const double height = 1.2 + 1.5 * LowestY(object) - 0.3;  // half as large again
  const Eigen::VectorXd r = Residuals(
      FloorCost(object, 0.02),
      {BlockOf(object.T_world_object), BlockOf(object.coefficients), {std::log(1.5)}, {0, 1, 0}, {0.3}});
  EXPECT_NEAR(r(0), height / 0.02, 1e-6);
}

TEST(FloorCost, LowestPointIsTheLowestOfAllEnds) {
  for (const char* category : {"chair", "table", "laptop"}) {
    const CategoryModel model = LoadModel(category);
    const GraphObject object = ExampleObject(model);
    const ShapePoint lowest = LowestPoint(*object.model, object.coefficients);
    EXPECT_NEAR((lowest.X0 + lowest.G * object.coefficients).y(), LowestY(object), 1e-9) << category;
  }
}

TEST(SupportCost, DerivativesAgreeWithDifferences) {
  const CategoryModel laptop = LoadModel("laptop"), table = LoadModel("table");
  const GraphObject object = ExampleObject(laptop), on = ExampleObject(table);
  ExpectJacobians(SupportCost(object, on, 0, 0.02), {BlockOf(object.T_world_object),
                                                     BlockOf(object.coefficients),
                                                     {0.2},
                                                     BlockOf(on.T_world_object),
                                                     BlockOf(on.coefficients),
                                                     {-0.1},
                                                     {0.1, -0.9, 0.3}});
}

// A laptop whose base is 0.8 m up, on a table whose top is 0.74 m up.
TEST(SupportCost, IsTheHeightAboveTheFace) {
  const CategoryModel laptop = LoadModel("laptop"), table = LoadModel("table");
  GraphObject object = ExampleObject(laptop), on = ExampleObject(table);
  on.coefficients.setZero();
  object.T_world_object = Pose({0, 0.8, 0}, {3, 0.8 - LowestY(object), -2});
  const double top = WireframeFromCoefficients(table, on.coefficients).midpoints(1, 0);
  on.T_world_object = Pose({0, 0, 0}, {3, 0.74 - top, -2});
  const Eigen::VectorXd r = Residuals(SupportCost(object, on, 0, 0.02), {BlockOf(object.T_world_object),
                                                                         BlockOf(object.coefficients),
                                                                         {0.0},
                                                                         BlockOf(on.T_world_object),
                                                                         BlockOf(on.coefficients),
                                                                         {0.0},
                                                                         {0, 1, 0}});
  EXPECT_NEAR(r(0), 0.06 / 0.02, 1e-6);
}

TEST(FindSupports, GivesTheTableThatALaptopStandsOn) {
  const CategoryModel laptop = LoadModel("laptop"), table = LoadModel("table"), chair = LoadModel("chair");
  MapGraph graph;
  graph.up_world = {0, 1, 0};
  const auto put = [&](const CategoryModel& model, double x, double lowest) {
    GraphObject object{&model, Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(model.modes())};
    object.T_world_object.translation() << x, lowest - LowestY(object), 0;
    graph.objects.push_back(object);
  };
  put(chair, 0.4, 0);  // pushed under the table: its seat is lower
  put(table, 0, 0);
  put(laptop, 0.3, 0.8);
  const std::vector<Support> supports = FindSupports(graph);
  ASSERT_EQ(supports.size(), 1u);
  EXPECT_EQ(supports[0].object, 2);
  EXPECT_EQ(supports[0].on, 1);
  graph.objects[2].T_world_object.translation().y() += 0.6;  // on a shelf above it
  EXPECT_TRUE(FindSupports(graph).empty());
  graph.objects[2].T_world_object.translation() += Eigen::Vector3d(3, -0.6, 0);  // beside it
  EXPECT_TRUE(FindSupports(graph).empty());
}

TEST(HeightCost, IsTheCamerasHeightAboveTheFloor) {
  const HeightCost cost({0, 1.5, 0.1});
  const Eigen::Isometry3d camera = Pose({0.3, 0.8, -0.2}, {3, 1.2, -2});
  // 1.2 m up, above a floor 0.4 m below the origin: 1.6 m instead of 1.5
  EXPECT_NEAR(Residuals(cost, {BlockOf(camera), {0, 1, 0}, {-0.4}})(0), 1.0, 1e-9);
  ExpectJacobians(cost, {BlockOf(camera), {0.1, -0.9, 0.3}, {-1.1}});
}

TEST(RandomWalkCost, IsTheStepInStandardDeviations) {
  const RandomWalkCost cost(0.02);
  EXPECT_NEAR(Residuals(cost, {{0.5}, {0.53}})(0), 1.5, 1e-9);
  ExpectJacobians(cost, {{0.5}, {0.53}});
}

}  // namespace
}  // namespace armature
