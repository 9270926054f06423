// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "association/matching.h"
#include "geometry/rotation.h"
#include "resection/line_resection.h"
#include "resection/resection_problem.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

using testing::SyntheticView;

Eigen::MatrixXd JacobianByDifferences(const ResectionProblem& problem, const Eigen::VectorXd& x) {
  const double h = 1e-6;
  Eigen::MatrixXd J(problem.NumResiduals(), x.size());
  Eigen::VectorXd ahead(problem.NumResiduals()), behind(problem.NumResiduals());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd step = x;
    step(i) += h;
    problem(step.data(), ahead.data(), nullptr);
    step(i) -= 2 * h;
    problem(step.data(), behind.data(), nullptr);
    J.col(i) = (ahead - behind) / (2 * h);
  }
  return J;
}

ResectionProblem ProblemOf(const SyntheticView& synthetic) {
  ResectionProblem problem;
  problem.camera = &synthetic.camera;
  problem.model = &synthetic.model;
  problem.R0 = synthetic.truth.T_camera_object.linear();
  problem.T0 = synthetic.truth.T_camera_object.translation();
  problem.up_camera = *synthetic.view.up_camera;
  problem.up_weight = 40;
  problem.shape_weight = 0.7;
  const Eigen::Vector3d line = Eigen::Vector3d(0.6, 0.8, -450);
  problem.line_terms.push_back({PointOnEdge(synthetic.model, 3, 0.2), line, 0.5, 3, false});
  problem.line_terms.push_back({PointOnEdge(synthetic.model, 7, -0.4), line, 0.1, 3, true});
  problem.line_terms.push_back({PointOnEdge(synthetic.model, 7, -0.4), -line, 0.1, 3, true});
  problem.plane_terms.push_back(
      {PointOnEdge(synthetic.model, 6, 0.5), *synthetic.view.up_camera, 1.2, 10, 3});
  return problem;
}

class ResectionDerivatives : public ::testing::TestWithParam<NormalTerm> {};

TEST_P(ResectionDerivatives, AgreeWithCentralDifferences) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  ResectionProblem problem = ProblemOf(synthetic);
  problem.normal_term = GetParam();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.NumParameters());
  x << 0.1, -0.2, 0.05, 0.02, 0.03, -0.04, 0.5, -0.4, 0.3, 0.2, -0.1, 0.15, 0.25;
  Eigen::VectorXd residuals(problem.NumResiduals());
  Eigen::MatrixXd J(problem.NumResiduals(), problem.NumParameters());
  problem(x.data(), residuals.data(), J.data());
  EXPECT_LT((J - JacobianByDifferences(problem, x)).cwiseAbs().maxCoeff(), 1e-5 * J.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(NormalTerms, ResectionDerivatives,
                         ::testing::Values(NormalTerm::kNone, NormalTerm::kAxis, NormalTerm::kBase,
                                           NormalTerm::kPrinted));

TEST(ResectionProblem, MemoryDerivativesAgreeWithCentralDifferences) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  ResectionProblem problem = ProblemOf(synthetic);
  ObjectMemory memory;
  memory.expected = synthetic.truth;
  const int n = 4 + synthetic.model.modes();
  // Not diagonal: the whitening must be by L^T.
  memory.sqrt_information = Eigen::MatrixXd::Identity(n, n) * 3;
  memory.sqrt_information(0, 4) = 2;
  memory.sqrt_information(2, 3) = -1.5;
  problem.memory = &memory;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(problem.NumParameters(), 0.05);
  Eigen::VectorXd residuals(problem.NumResiduals());
  Eigen::MatrixXd J(problem.NumResiduals(), problem.NumParameters());
  problem(x.data(), residuals.data(), J.data());
  EXPECT_LT((J - JacobianByDifferences(problem, x)).cwiseAbs().maxCoeff(), 1e-5 * J.cwiseAbs().maxCoeff());
}

TEST(ResectionProblem, LineResidualIsTheDistanceInPixels) {
  const SyntheticView synthetic("chair", 0.5, {0, 0, 2}, Eigen::Vector3d::Zero());
  ResectionProblem problem = ProblemOf(synthetic);
  const ShapePoint point = PointOnEdge(synthetic.model, 0, 0);
  const Eigen::Vector2d pixel = synthetic.camera.Project(problem.R0 * point.X0 + problem.T0);
  // A horizontal image line 7 pixels above the point; a huge loss scale leaves the residual as it is.
  problem.line_terms = {{point, {0, 1, -(pixel.y() - 7)}, 1, 1e9, false}};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.NumParameters()), residuals(problem.NumResiduals());
  problem(x.data(), residuals.data(), nullptr);
  EXPECT_NEAR(residuals(0), 7, 1e-9);
}

TEST(ResectionProblem, AnUprightChairHasNoNormalResidual) {
  const SyntheticView synthetic("table", 0.5, {0, 0.2, 3}, Eigen::Vector3d::Zero());
  ResectionProblem problem = ProblemOf(synthetic);
  problem.line_terms.clear();
  problem.plane_terms.clear();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.NumParameters()), residuals(problem.NumResiduals());
  for (const NormalTerm term : {NormalTerm::kAxis, NormalTerm::kBase}) {
    problem.normal_term = term;
    problem(x.data(), residuals.data(), nullptr);
    EXPECT_LT(residuals.head<3>().norm(), 0.02 * problem.up_weight);
  }
}

double PoseError(const PoseAndShape& estimate, const PoseAndShape& truth) {
  return (estimate.T_camera_object.translation() - truth.T_camera_object.translation()).norm() +
         LogSO3(estimate.T_camera_object.linear() * truth.T_camera_object.linear().transpose()).norm();
}

ResectionResult ResectRounds(const SyntheticView& synthetic, PoseAndShape at,
                             const ResectionOptions& options) {
  ResectionResult result;
  for (int round = 0; round < 12; ++round) {
    const ProjectedWireframe projected = synthetic.Project(at);
    const Matching matching = MatchSegments(projected, synthetic.view.segments, {30, 0.3});
    result =
        Resect(synthetic.view, synthetic.view.sides, matching.matches, projected, at, BoxOptions{}, options);
    at = result.estimate;
  }
  return result;
}

TEST(Resection, RecoversPoseAndShapeFromPerfectLines) {
  for (const char* category : {"chair", "table"}) {
    const SyntheticView synthetic(category, 0.6, {0.1, 0.2, 2.8}, Eigen::Vector2d(0.8, -0.6));
    PoseAndShape start = synthetic.truth;
    start.coefficients.setZero();
    start.T_camera_object.translation() += Eigen::Vector3d(0.02, -0.02, 0.08);
    start.T_camera_object.linear() = ExpSO3({0.01, 0.05, 0.01}) * start.T_camera_object.linear();
    ResectionOptions options;
    options.max_iterations = 30;
    options.shape_weight = 0.01;  // hardly a prior: the lines and the box decide
    const ResectionResult result = ResectRounds(synthetic, start, options);
    EXPECT_TRUE(result.finite);
    EXPECT_LT(PoseError(result.estimate, synthetic.truth), 0.25 * PoseError(start, synthetic.truth))
        << category;
  }
}

TEST(Resection, JointCostIsNoHigherThanAlternating) {
  const SyntheticView synthetic("chair", 0.6, {0.1, 0.2, 2.8}, Eigen::Vector2d(0.8, -0.6));
  PoseAndShape start = synthetic.truth;
  start.coefficients.setZero();
  start.T_camera_object.translation().z() += 0.1;
  const ProjectedWireframe projected = synthetic.Project(start);
  const Matching matching = MatchSegments(projected, synthetic.view.segments, {30, 0.3});
  ResectionOptions joint, alternating;
  joint.max_iterations = alternating.max_iterations = 30;
  alternating.mode = "alternating";
  const auto cost = [&](const ResectionOptions& options) {
    return Resect(synthetic.view, synthetic.view.sides, matching.matches, projected, start, BoxOptions{},
                  options)
        .cost;
  };
  EXPECT_LE(cost(joint), cost(alternating) * 1.001);
}

TEST(Resection, DepthIsTheLeastCertainDirection) {
  const SyntheticView synthetic("chair", 0.6, {0, 0.2, 2.8}, Eigen::Vector2d::Zero());
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  const Matching matching = MatchSegments(projected, synthetic.view.segments, {4, 0.1});
  const Eigen::Matrix<double, 6, 6> covariance =
      PoseCovariance(synthetic.view, synthetic.view.sides, matching.matches, projected, synthetic.truth,
                     BoxOptions{}, ResectionOptions{});
  EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-9);
  EXPECT_GT(covariance(5, 5), 10 * covariance(3, 3));
  EXPECT_GT(covariance(5, 5), 10 * covariance(4, 4));
  EXPECT_EQ(covariance.llt().info(), Eigen::Success);
}

}  // namespace
}  // namespace armature
