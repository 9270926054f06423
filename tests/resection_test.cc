// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "association/matching.h"
#include "geometry/rotation.h"
#include "resection/line_resection.h"
#include "resection/normal_equations.h"
#include "resection/resection_problem.h"
#include "resection/resection_solver.h"
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

// At the truth, without lines.
ResectionProblem BareProblem(const SyntheticView& synthetic) {
  ResectionProblem problem;
  problem.camera = &synthetic.camera;
  problem.model = &synthetic.model;
  problem.R0 = synthetic.truth.T_camera_object.linear();
  problem.T0 = synthetic.truth.T_camera_object.translation();
  problem.up_camera = *synthetic.view.up_camera;
  problem.up_weight = 40;
  return problem;
}

ResectionProblem ProblemOf(const SyntheticView& synthetic) {
  ResectionProblem problem = BareProblem(synthetic);
  problem.shape_weight = 0.7;
  const Eigen::Vector3d line = Eigen::Vector3d(0.6, 0.8, -450);
  problem.line_terms.push_back({PointOnEdge(synthetic.model, 3, 0.2), line, 0.5, 3, false});
  problem.line_terms.push_back({PointOnEdge(synthetic.model, 7, -0.4), line, 0.1, 3, true});
  problem.line_terms.push_back({PointOnEdge(synthetic.model, 7, -0.4), -line, 0.1, 3, true});
  problem.plane_terms.push_back(
      {PointOnEdge(synthetic.model, 6, 0.5), *synthetic.view.up_camera, 1.2, 10, 3});
  // Exactly on its line: no residual, but a derivative.
  const ShapePoint touching = PointOnEdge(synthetic.model, 2, 0.1);
  const Eigen::Vector2d pixel = synthetic.camera.Project(problem.R0 * touching.X0 + problem.T0);
  problem.line_terms.push_back({touching, {1, 0, -pixel.x()}, 0.3, 3, false});
  return problem;
}

// Not diagonal: the whitening must be by L^T.
TrackPrior MemoryOf(const SyntheticView& synthetic) {
  TrackPrior memory;
  memory.expected = synthetic.truth;
  const int n = 4 + synthetic.model.modes();
  memory.sqrt_information = Eigen::MatrixXd::Identity(n, n) * 3;
  memory.sqrt_information(0, 4) = 2;
  memory.sqrt_information(2, 3) = -1.5;
  memory.information = memory.sqrt_information.transpose() * memory.sqrt_information;
  return memory;
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
  const TrackPrior memory = MemoryOf(synthetic);
  problem.track_prior = &memory;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(problem.NumParameters(), 0.05);
  Eigen::VectorXd residuals(problem.NumResiduals());
  Eigen::MatrixXd J(problem.NumResiduals(), problem.NumParameters());
  problem(x.data(), residuals.data(), J.data());
  EXPECT_LT((J - JacobianByDifferences(problem, x)).cwiseAbs().maxCoeff(), 1e-5 * J.cwiseAbs().maxCoeff());
}

template <int kModes>
void ExpectNormalEquationsOfTheJacobian(const ResectionProblem& problem, const Eigen::VectorXd& x) {
  Eigen::VectorXd r(problem.NumResiduals());
  Eigen::MatrixXd J(problem.NumResiduals(), problem.NumParameters());
  problem(x.data(), r.data(), J.data());
  const auto equations = Linearise<kModes>(problem, x.data());
  const Eigen::MatrixXd JtJ = J.transpose() * J;
  EXPECT_LT((equations.information - JtJ).cwiseAbs().maxCoeff(), 1e-10 * JtJ.cwiseAbs().maxCoeff());
  EXPECT_LT((equations.gradient - J.transpose() * r).cwiseAbs().maxCoeff(),
            1e-10 * JtJ.cwiseAbs().maxCoeff());
  EXPECT_NEAR(equations.cost, r.squaredNorm() / 2, 1e-10 * r.squaredNorm());
}

TEST_P(ResectionDerivatives, GiveTheNormalEquationsOfTheirJacobian) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  ResectionProblem problem = ProblemOf(synthetic);
  problem.normal_term = GetParam();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.NumParameters());
  x << 0.1, -0.2, 0.05, 0.02, 0.03, -0.04, 0.5, -0.4, 0.3, 0.2, -0.1, 0.15, 0.25;
  const TrackPrior memory = MemoryOf(synthetic);
  for (const TrackPrior* remembered : {static_cast<const TrackPrior*>(nullptr), &memory}) {
    problem.track_prior = remembered;
    ExpectNormalEquationsOfTheJacobian<7>(problem, x);
    ExpectNormalEquationsOfTheJacobian<Eigen::Dynamic>(problem, x);
  }
}

// A segment through the principal point along the rows lies in the plane of normal (0, 1, 0): of eq. 19's two
// squares, M moves with T along y and D does not, and what is known of T is 1 / sigma^2 along y alone.
TEST(LineTerm, PlanesMeasureTheEdgeAcrossTheSegmentsPlaneInMetres) {
  SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  synthetic.view.up_camera.reset();
  const std::vector<EdgeMatch> matches{{3, {{400, 239.5}, {500, 239.5}}, 0}};
  ResectionOptions options;
  options.line_term = LineTerm::kPlanes;
  options.box_weight = 0;
  options.up_sigma_deg = 2;
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  const ImageEvidence evidence = EvidenceAt(
      {synthetic.view, synthetic.view.sides, matches, projected, synthetic.truth, BoxOptions{}, options});
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  expected(1, 1) = std::pow(90 / M_PI, 2);
  EXPECT_TRUE((evidence.information.block<3, 3>(3, 3)).isApprox(expected, 1e-9));
  EXPECT_TRUE(evidence.gradient.isZero(0)) << "the estimate is what was measured";
}

// A well-posed problem: every edge is seen, by segments that are a little off.
ResectionProblem SolvableProblem(const SyntheticView& synthetic) {
  ResectionProblem problem = ProblemOf(synthetic);
  problem.line_terms.clear();
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  for (size_t e = 0; e < projected.edges.size(); ++e) {
    const ProjectedEdge& edge = projected.edges[e];
    if (edge.length <= 0) continue;
    const double off = e % 2 == 0 ? 1.5 : -0.5;  // pixels
    const Eigen::Vector2d n(-edge.direction.y(), edge.direction.x());
    const Eigen::Vector3d line(n.x(), n.y(), -n.dot(edge.line.p1) + off);
    for (const double s : {-0.4, 0.3}) {
      problem.line_terms.push_back(
          {PointOnEdge(synthetic.model, static_cast<int>(e), s), line, 0.5, 3, false});
    }
  }
  return problem;
}

// From several starts, so that steps are turned down, too.
TEST(ResectionSolver, AgreesWithCeres) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  ResectionProblem problem = SolvableProblem(synthetic);
  const TrackPrior memory = MemoryOf(synthetic);
  const SolverOptions options{.max_iterations = 300, .function_tolerance = 0, .parameter_tolerance = 1e-12};
  for (const double off : {0.0, 0.02, 0.08}) {
    for (const TrackPrior* remembered : {static_cast<const TrackPrior*>(nullptr), &memory}) {
      problem.track_prior = remembered;
      Eigen::VectorXd ours = Eigen::VectorXd::Constant(problem.NumParameters(), off), theirs = ours;
      const SolverResult small = SolveResection(problem, options, ours);
      const SolverResult ceres = SolveResectionWithCeres(problem, options, theirs);
      EXPECT_NEAR(small.cost, ceres.cost, 1e-9 * ceres.cost);
      EXPECT_LT((ours - theirs).cwiseAbs().maxCoeff(), 1e-6) << off;
    }
  }
}

TEST(ResectionSolver, TakesTheSameStepsAsCeres) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  const ResectionProblem problem = SolvableProblem(synthetic);
  for (int iterations = 1; iterations < 12; ++iterations) {
    const SolverOptions options{.max_iterations = iterations};
    Eigen::VectorXd ours = Eigen::VectorXd::Constant(problem.NumParameters(), 0.05), theirs = ours;
    EXPECT_EQ(SolveResection(problem, options, ours).iterations,
              SolveResectionWithCeres(problem, options, theirs).iterations);
    EXPECT_LT((ours - theirs).cwiseAbs().maxCoeff(), 1e-9) << iterations;
  }
}

TEST(ResectionSolver, OtherNumbersOfModesComeToTheSame) {
  SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.5, -0.4, 0.3));
  synthetic.model.basis.conservativeResize(Eigen::NoChange, 4);
  synthetic.model.standard_deviations.conservativeResize(4);
  synthetic.truth.coefficients.conservativeResize(4);
  const ResectionProblem problem = SolvableProblem(synthetic);
  const SolverOptions options{.max_iterations = 300, .function_tolerance = 0, .parameter_tolerance = 1e-12};
  Eigen::VectorXd ours = Eigen::VectorXd::Zero(10), theirs = ours;
  SolveResection(problem, options, ours);
  SolveResectionWithCeres(problem, options, theirs);
  EXPECT_LT((ours - theirs).cwiseAbs().maxCoeff(), 1e-6);
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

// What the normal term says of an object that is turned by an angle from upright, as a share of the weight.
double NormalResidual(const std::string& category, NormalTerm term, double tilt) {
  const SyntheticView synthetic(category, 0.5, {0, 0.2, 3}, Eigen::Vector3d::Zero());
  ResectionProblem problem = BareProblem(synthetic);
  problem.normal_term = term;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.NumParameters()), residuals(problem.NumResiduals());
  x(2) = tilt;
  problem(x.data(), residuals.data(), nullptr);
  return residuals.head<3>().norm() / problem.up_weight;
}

TEST(ResectionProblem, AnUprightObjectHasNoNormalResidual) {
  for (const char* category : {"chair", "table", "laptop"}) {
    for (const NormalTerm term : {NormalTerm::kAxis, NormalTerm::kBase}) {
      // A chair's base edges are those of an average, and not quite level.
      EXPECT_LT(NormalResidual(category, term, 0), term == NormalTerm::kAxis ? 1e-9 : 0.02) << category;
      EXPECT_NEAR(NormalResidual(category, term, 0.1), 0.1, 0.02) << category;
    }
  }
}

double PoseError(const PoseAndShape& estimate, const PoseAndShape& truth) {
  return (estimate.T_camera_object.translation() - truth.T_camera_object.translation()).norm() +
         LogSO3(estimate.T_camera_object.linear() * truth.T_camera_object.linear().transpose()).norm();
}

ResectionResult ResectRounds(const SyntheticView& synthetic, PoseAndShape at, const ResectionOptions& options,
                             int rounds) {
  ResectionResult result;
  for (int round = 0; round < rounds; ++round) {
    const ProjectedWireframe projected = synthetic.Project(at);
    const Matching matching = MatchSegments(projected, synthetic.view.segments, {30, 0.3});
    result = Resect(
        {synthetic.view, synthetic.view.sides, matching.matches, projected, at, BoxOptions{}, options});
    at = result.estimate;
  }
  return result;
}

struct RecoveryBound {
  std::string category;
  int rounds;
  double pose;   // metres and radians
  double shape;  // standard deviations, the largest error of a coefficient
};

// Twice what is reached. A table's last mode hardly moves the lines of this view: it comes in slowly.
TEST(Resection, RecoversPoseAndShapeFromPerfectLines) {
  for (const auto& [category, rounds, pose, shape] :
       {RecoveryBound{"chair", 12, 3e-5, 5e-5}, {"table", 144, 5e-3, 0.08}}) {
    const SyntheticView synthetic(category, 0.6, {0.1, 0.2, 2.8}, Eigen::Vector2d(0.8, -0.6));
    PoseAndShape start = synthetic.truth;
    start.coefficients.setZero();
    start.T_camera_object.translation() += Eigen::Vector3d(0.02, -0.02, 0.08);
    start.T_camera_object.linear() = ExpSO3({0.01, 0.05, 0.01}) * start.T_camera_object.linear();
    ResectionOptions options;
    options.max_iterations = 30;
    options.shape_weight = 0.01;  // hardly a prior: the lines and the box decide
    const ResectionResult result = ResectRounds(synthetic, start, options, rounds);
    EXPECT_TRUE(result.finite());
    EXPECT_LT(PoseError(result.estimate, synthetic.truth), pose) << category;
    EXPECT_LT((result.estimate.coefficients - synthetic.truth.coefficients).cwiseAbs().maxCoeff(), shape)
        << category;
    // Nothing is left but the prior's cost of the true shape.
    EXPECT_NEAR(result.cost, 0.5 * 0.01 * 0.01 * synthetic.truth.coefficients.squaredNorm(), 5e-7)
        << category;
  }
}

TEST(Resection, SaysWhyItStopped) {
  const SyntheticView synthetic("chair", 0.6, {0.1, 0.2, 2.8}, Eigen::Vector2d(0.8, -0.6));
  PoseAndShape start = synthetic.truth;
  start.T_camera_object.translation().z() += 0.1;
  ResectionOptions options;
  options.max_iterations = 1;
  EXPECT_EQ(ResectRounds(synthetic, start, options, 1).stop, StopReason::kMaxIterations);
  options.max_iterations = 100;
  const ResectionResult result = ResectRounds(synthetic, start, options, 1);
  EXPECT_TRUE(result.stop == StopReason::kCost || result.stop == StopReason::kStep)
      << StopReasonName(result.stop);
  EXPECT_TRUE(result.finite());
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
  alternating.mode = ResectionMode::kAlternating;
  const auto cost = [&](const ResectionOptions& options) {
    return Resect({synthetic.view, synthetic.view.sides, matching.matches, projected, start, BoxOptions{},
                   options})
        .cost;
  };
  EXPECT_LE(cost(joint), cost(alternating) * 1.001);
}

TEST(Resection, DepthIsTheLeastCertainDirection) {
  const SyntheticView synthetic("chair", 0.6, {0, 0.2, 2.8}, Eigen::Vector2d::Zero());
  const ProjectedWireframe projected = synthetic.Project(synthetic.truth);
  const Matching matching = MatchSegments(projected, synthetic.view.segments, {4, 0.1});
  const Eigen::Matrix<double, 6, 6> covariance =
      PoseCovariance({synthetic.view, synthetic.view.sides, matching.matches, projected, synthetic.truth,
                      BoxOptions{}, ResectionOptions{}});
  EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-9);
  EXPECT_GT(covariance(5, 5), 10 * covariance(3, 3));
  EXPECT_GT(covariance(5, 5), 10 * covariance(4, 4));
  EXPECT_EQ(covariance.llt().info(), Eigen::Success);
}

}  // namespace
}  // namespace armature
