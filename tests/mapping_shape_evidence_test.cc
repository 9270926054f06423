// SPDX-License-Identifier: BSD-3-Clause
// What images say of a shape, against the same system solved the long way.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "mapping/object_factors.h"
#include "mapping/shape_evidence.h"
#include "resection/resection_problem.h"
#include "support/category_examples.h"

namespace armature {
namespace {

using testing::FrameModel;

constexpr double kSurely = 1e-4;   // of the logarithm of the scale: next to held
constexpr Eigen::Index kSize = 9;  // of a factor

MapSolverOptions FactorsAlone() {
  MapSolverOptions options;
  options.loss_scale = 1e6;
  options.upright_sigma_deg = options.floor_sigma = 0;
  return options;
}

// Of full rank, another for each number.
Eigen::MatrixXd FactorMatrix(int number) {
  return Eigen::MatrixXd::NullaryExpr(kSize, kSize, [&](Eigen::Index i, Eigen::Index j) {
    return (i == j ? 6 : 0) + 2 * std::sin(1.7 * number + 2.3 * static_cast<double>(i * kSize + j));
  });
}

// Three held cameras around one object; each has its own opinion of the shape, and sees the object where it
// is.
struct WatchedObject {
  CategoryModel model = FrameModel();
  MapGraph graph;

  explicit WatchedObject(bool on_floor = false) {
    model.spec.stands_on_floor = on_floor;
    graph.cameras_are_held = graph.scale_is_held = true;
    graph.objects.push_back({&model, Eigen::Isometry3d::Identity(), Eigen::Vector3d(0.4, -0.3, 0.6)});
    GraphObject& object = graph.objects.front();
    object.T_world_object.linear() = ExpSO3({0, 0.7, 0}) * Eigen::Vector3d(-1, -1, 1).asDiagonal();
    object.T_world_object.translation() << 0.3, 1.2, 2.5;
    for (int i = 0; i < 3; ++i) {
      Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
      camera.linear() = ExpSO3({0.1, 0.3 - 0.3 * i, 0.02 * i});
      camera.translation() << -0.8 + 0.8 * i, 0.1 * i, 0.2;
      graph.T_world_camera.push_back(camera);
      ObjectFactor factor;
      factor.camera = i;
      factor.at = {camera.inverse() * object.T_world_object,
                   object.coefficients + 0.1 * Eigen::Vector3d(i - 1, 1 - i, 0.5 * i)};
      factor.A = FactorMatrix(i);
      factor.b = Eigen::VectorXd::Zero(kSize);
      graph.observations.push_back(factor);
    }
  }

  ShapeEvidence Evidence(const MapSolverOptions& options, double scale_sigma = kSurely) const {
    return ComputeShapeEvidence(graph, 0, scale_sigma, options);
  }
};

// The robust residuals of all factors after a step x of pose (6), shape (3) and logarithm of the world's
// scale; the weights stay as they are at x = 0.
Eigen::VectorXd ResidualsAt(const MapGraph& graph, const MapSolverOptions& options,
                            const Eigen::VectorXd& x) {
  const GraphObject& object = graph.objects.front();
  std::vector<double> all;
  for (const ObjectFactor& factor : graph.observations) {
    const auto seen = [&](const Eigen::VectorXd& at) {
      Eigen::Isometry3d camera = graph.T_world_camera[static_cast<size_t>(factor.camera)];
      Eigen::Isometry3d moved = object.T_world_object;
      camera.translation() *= std::exp(at(9));
      moved.translation() *= std::exp(at(9));
      return Residual(
          factor, {camera.inverse() * moved * ExpSE3(at.head<6>()), object.coefficients + at.segment<3>(6)});
    };
    const double c2 = options.loss_scale * options.loss_scale * static_cast<double>(kSize);
    const double weight = 1 / (1 + seen(Eigen::VectorXd::Zero(10)).squaredNorm() / c2);
    const Eigen::VectorXd residual = std::sqrt(weight) * seen(x);
    all.insert(all.end(), residual.begin(), residual.end());
  }
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

// Upright, and on a floor that is known by the sigma.
Eigen::VectorXd StandAt(const MapGraph& graph, double upright_sigma, double floor_sigma,
                        const Eigen::VectorXd& x) {
  const GraphObject& object = graph.objects.front();
  const Eigen::Isometry3d moved = object.T_world_object * ExpSE3(x.head<6>());
  const ShapePoint lowest = LowestPoint(*object.model, object.coefficients);
  const Eigen::Vector3d point = lowest.X0 + lowest.G * (object.coefficients + x.segment<3>(6));
  Eigen::VectorXd residuals(4);
  residuals << moved.linear().col(1) / upright_sigma, graph.up_world.dot(moved * point) / floor_sigma;
  return residuals;
}

template <typename Function>
Eigen::MatrixXd CentralDifferences(const Function& residuals) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd J(residuals(Eigen::VectorXd::Zero(10)).size(), 10);
  for (Eigen::Index i = 0; i < 10; ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(10, i);
    J.col(i) = (residuals(step) - residuals(-step)) / (2 * kStep);
  }
  return J;
}

// The information of the shape from that of everything: its block of the covariance, inverted again.
Eigen::MatrixXd ShapeInformation(Eigen::MatrixXd H, double scale_sigma) {
  H(9, 9) += 1 / (scale_sigma * scale_sigma);
  return Eigen::MatrixXd(H.inverse()).block(6, 6, 3, 3).inverse();
}

TEST(ShapeEvidence, IsMarginalOverPoseAndScale) {
  WatchedObject watched;
  for (ObjectFactor& factor : watched.graph.observations) {
    factor.at.coefficients = watched.graph.objects.front().coefficients;
    factor.b.setConstant(1.5);
  }
  MapSolverOptions options = FactorsAlone();
  options.loss_scale = 1;  // the weights count
  const Eigen::MatrixXd J =
      CentralDifferences([&](const Eigen::VectorXd& x) { return ResidualsAt(watched.graph, options, x); });
  for (const double scale_sigma : {0.001, 0.03, 1.0}) {
    const Eigen::MatrixXd expected = ShapeInformation(J.transpose() * J, scale_sigma);
    EXPECT_TRUE(watched.Evidence(options, scale_sigma).information.isApprox(expected, 1e-5)) << scale_sigma;
  }
  EXPECT_GT(watched.Evidence(options, 0.001).information.trace(),
            1.01 * watched.Evidence(options, 1).information.trace());
}

TEST(ShapeEvidence, UprightOnTheFloorThatAnotherStandsOn) {
  WatchedObject watched(true);
  watched.graph.objects.push_back(watched.graph.objects.front());
  MapSolverOptions options = FactorsAlone();
  options.upright_sigma_deg = 0.5;
  options.floor_sigma = 0.01;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(10, 10);
  const auto add = [&](const Eigen::MatrixXd& J) { H += J.transpose() * J; };
  add(CentralDifferences([&](const auto& x) { return ResidualsAt(watched.graph, options, x); }));
  // Of the difference to another that stands as surely.
  add(CentralDifferences(
      [&](const auto& x) { return StandAt(watched.graph, 0.5 * kDegree, std::sqrt(2) * 0.01, x); }));
  EXPECT_TRUE(watched.Evidence(options).information.isApprox(ShapeInformation(H, kSurely), 1e-4));
}

TEST(ShapeEvidence, NoOthersNoFloor) {
  const WatchedObject watched(true);
  MapSolverOptions options = FactorsAlone();
  const Eigen::MatrixXd without = watched.Evidence(options).information;
  options.floor_sigma = 0.001;
  EXPECT_EQ(watched.Evidence(options).information, without);
}

TEST(ShapeEvidence, ItsMeanIsTheShapeThatTheImagesAloneWouldHave) {
  WatchedObject watched(true);
  watched.graph.up_sigma = 1e-4;
  MapSolverOptions options;
  options.loss_scale = 1e6;
  options.shape_weight = 3;
  for (int i = 0; i < 10; ++i) SolveMapGraph(watched.graph, options);
  const ShapeEvidence evidence = watched.Evidence(options);
  const Eigen::VectorXd with_prior = watched.graph.objects.front().coefficients;
  options.shape_weight = 0;
  for (int i = 0; i < 10; ++i) SolveMapGraph(watched.graph, options);
  const Eigen::VectorXd alone = watched.graph.objects.front().coefficients;
  EXPECT_GT((with_prior - alone).norm(), 0.02) << "the prior has to matter";
  const Eigen::VectorXd mean = evidence.information.llt().solve(evidence.vector);
  EXPECT_LT((mean - alone).norm(), 0.02 * (with_prior - alone).norm());
}

TEST(ShapeEvidence, WhatNoImageShowsHasNoInformation) {
  WatchedObject watched;
  for (ObjectFactor& factor : watched.graph.observations) factor.A.col(7).setZero();
  MapSolverOptions options = FactorsAlone();
  SolveMapGraph(watched.graph, options);
  const ShapeEvidence evidence = watched.Evidence(options);
  EXPECT_LT(evidence.information.row(1).norm(), 1e-6);
  EXPECT_LT(std::abs(evidence.vector(1)), 1e-3);
  EXPECT_GT(evidence.information(0, 0), 1);
  EXPECT_GT(evidence.information(2, 2), 1);
}

// Images that see an edge's direction but not where the object is.
TEST(ShapeEvidence, AnUnknownPoseIsNoObstacle) {
  WatchedObject watched;
  for (ObjectFactor& factor : watched.graph.observations) factor.A.leftCols<6>().setZero();
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (const ObjectFactor& factor : watched.graph.observations)
    expected += factor.A.rightCols<3>().transpose() * factor.A.rightCols<3>();
  EXPECT_TRUE(watched.Evidence(FactorsAlone()).information.isApprox(expected, 1e-6));
}

TEST(ShapeEvidence, OnlyTheObjectsOwnFactorsCount) {
  WatchedObject watched;
  const Eigen::MatrixXd before = watched.Evidence(FactorsAlone()).information;
  watched.graph.objects.push_back(watched.graph.objects.front());
  watched.graph.observations.push_back(watched.graph.observations.front());
  watched.graph.observations.back().object = 1;
  EXPECT_EQ(watched.Evidence(FactorsAlone()).information, before);
}

TEST(ShapeEvidence, AnOutlyingFactorCountsLess) {
  WatchedObject watched;
  MapSolverOptions options = FactorsAlone();
  options.loss_scale = 3;
  double before = watched.Evidence(options).information.trace();
  for (const double off : {2.0, 5.0, 20.0}) {
    watched.graph.observations.back().b.setConstant(off);
    const double now = watched.Evidence(options).information.trace();
    EXPECT_LT(now, 0.98 * before) << off;
    before = now;
  }
  watched.graph.observations.back().b.setConstant(1e6);
  const Eigen::MatrixXd outlying = watched.Evidence(options).information;
  watched.graph.observations.pop_back();
  EXPECT_TRUE(outlying.isApprox(watched.Evidence(options).information, 1e-6));
}

}  // namespace
}  // namespace armature
