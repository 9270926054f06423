// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/se3.h"
#include "mapping/object_factors.h"

namespace armature {
namespace {

constexpr int kModes = 3;
constexpr FactorNoise kNoNoise{.measurement_scale = 1,
                               .depth_sigma = 1e-6,
                               .lateral_sigma = 1e-6,
                               .rotation_sigma_deg = 1e-4,
                               .shape_sigma = 1e-6};

PoseAndShape ExamplePose() {
  PoseAndShape at;
  at.T_camera_object.linear() = ExpSO3({0.4, 2.1, -0.3});
  at.T_camera_object.translation() << 0.6, 0.4, 2.8;
  at.coefficients = Eigen::Vector3d(0.5, -0.2, 0.8);
  return at;
}

// Of full rank and not diagonal.
ImageEvidence ExampleEvidence() {
  constexpr int kSize = 6 + kModes;
  Eigen::MatrixXd J(2 * kSize, kSize);
  for (int i = 0; i < 2 * kSize; ++i) {
    for (int j = 0; j < kSize; ++j) J(i, j) = 20 * std::sin(1.0 + 2.3 * i * (j + 1) + 0.7 * j * j);
  }
  return {J.transpose() * J, J.transpose() * Eigen::VectorXd::LinSpaced(J.rows(), -0.4, 0.7)};
}

Eigen::MatrixXd InformationOf(const ObjectFactor& factor) { return factor.A.transpose() * factor.A; }
Eigen::VectorXd GradientOf(const ObjectFactor& factor) { return factor.A.transpose() * factor.b; }

// d of the factor, along the object's axes, to d of the evidence, along the camera's.
Eigen::MatrixXd ToCameraAxes(const PoseAndShape& at) {
  Eigen::MatrixXd G = Eigen::MatrixXd::Identity(6 + kModes, 6 + kModes);
  G.topLeftCorner<3, 3>() = at.T_camera_object.linear();
  G.block<3, 3>(3, 3) = at.T_camera_object.linear();
  return G;
}

double LeastEigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().minCoeff();
}

// Another place from which to see the object: not on a line with the factor's own.
PoseAndShape SeenElsewhere(const PoseAndShape& at) {
  Vector6d step;
  step << 0.2, 0.5, -0.1, 0.1, -0.3, 0.4;
  return {at.T_camera_object * ExpSE3(step), at.coefficients + Eigen::Vector3d(0.3, -0.6, 0.2)};
}

PoseAndShape Turned(PoseAndShape at, double angle) {
  at.T_camera_object.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
  return at;
}

// --- From evidence to a factor

TEST(MakeObjectFactor, IsTheEvidenceAlongTheObjectsAxes) {
  const PoseAndShape at = ExamplePose();
  const ImageEvidence evidence = ExampleEvidence();
  const ObjectFactor factor = MakeObjectFactor(evidence, at, 0, kNoNoise);
  const Eigen::MatrixXd G = ToCameraAxes(at);
  EXPECT_TRUE(InformationOf(factor).isApprox(G.transpose() * evidence.information * G, 1e-3));
  EXPECT_TRUE(GradientOf(factor).isApprox(G.transpose() * evidence.gradient, 1e-3));
  EXPECT_TRUE(factor.at.T_camera_object.isApprox(at.T_camera_object));
  EXPECT_EQ(factor.at.coefficients, at.coefficients);
}

// For a small step of the object, R = exp(w) R_at and t = t_at + v, residual and evidence tell one cost.
TEST(MakeObjectFactor, ItsCostIsTheEvidencesCost) {
  const PoseAndShape at = ExamplePose();
  const ImageEvidence evidence = ExampleEvidence();
  const ObjectFactor factor = MakeObjectFactor(evidence, at, 0, kNoNoise);
  const auto cost = [&](const PoseAndShape& seen) { return 0.5 * Residual(factor, seen).squaredNorm(); };
  for (Eigen::Index i = 0; i < 6 + kModes; ++i) {
    const Eigen::VectorXd d = 1e-3 * Eigen::VectorXd::Unit(6 + kModes, i);
    PoseAndShape seen = at;
    seen.T_camera_object.linear() = ExpSO3(d.head<3>()) * at.T_camera_object.linear();
    seen.T_camera_object.translation() += d.segment<3>(3);
    seen.coefficients += d.tail(kModes);
    const double expected = 0.5 * d.dot(evidence.information * d) + evidence.gradient.dot(d);
    EXPECT_NEAR(cost(seen) - cost(at), expected, 2e-3 * std::abs(expected)) << "direction " << i;
  }
}

TEST(MakeObjectFactor, StandardDeviationsAreMultiplied) {
  FactorNoise twice = kNoNoise;
  twice.measurement_scale = 2;
  const ObjectFactor a = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, kNoNoise);
  const ObjectFactor b = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, twice);
  EXPECT_TRUE((4 * InformationOf(b)).isApprox(InformationOf(a), 1e-3));
  EXPECT_TRUE((4 * GradientOf(b)).isApprox(GradientOf(a), 1e-3));
}

TEST(MakeObjectFactor, NoiseAddsToTheCovariance) {
  const PoseAndShape at = ExamplePose();
  const FactorNoise noise{.measurement_scale = 1,
                          .depth_sigma = 0.1,
                          .lateral_sigma = 0.1,
                          .rotation_sigma_deg = 5,
                          .shape_sigma = 0.5};
  const Eigen::MatrixXd clean = InformationOf(MakeObjectFactor(ExampleEvidence(), at, 0, kNoNoise));
  const Eigen::MatrixXd noisy = InformationOf(MakeObjectFactor(ExampleEvidence(), at, 0, noise));
  const Eigen::MatrixXd added = noisy.inverse() - clean.inverse();
  const double distance = at.T_camera_object.translation().norm();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(added(i, i), std::pow(5 * kDegree, 2), 1e-4) << i;
    EXPECT_GT(added(3 + i, 3 + i), 0.99 * std::pow(0.1 * distance, 2)) << i;
    EXPECT_NEAR(added(6 + i, 6 + i), 0.25, 1e-3) << i;
  }
}

TEST(MakeObjectFactor, MoreNoiseNeverGivesMoreInformation) {
  const PoseAndShape at = ExamplePose();
  FactorNoise noise = kNoNoise;
  Eigen::MatrixXd before = InformationOf(MakeObjectFactor(ExampleEvidence(), at, 0, noise));
  for (double FactorNoise::*field :
       {&FactorNoise::measurement_scale, &FactorNoise::depth_sigma, &FactorNoise::lateral_sigma,
        &FactorNoise::rotation_sigma_deg, &FactorNoise::shape_sigma}) {
    noise.*field = field == &FactorNoise::rotation_sigma_deg ? 5 : noise.*field + 0.3;
    const Eigen::MatrixXd now = InformationOf(MakeObjectFactor(ExampleEvidence(), at, 0, noise));
    EXPECT_GT(LeastEigenvalue(before - now), -1e-6 * before.norm());
    EXPECT_LT(now.norm(), 0.999 * before.norm());
    before = now;
  }
}

// The optimum that one image alone has does not move with the noise.
TEST(MakeObjectFactor, NoiseLeavesTheOptimumWhereItIs) {
  const FactorNoise noise;
  const auto optimum = [](const ObjectFactor& factor) -> Eigen::VectorXd {
    return -factor.A.triangularView<Eigen::Upper>().solve(factor.b);
  };
  const Eigen::VectorXd clean = optimum(MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, kNoNoise));
  const Eigen::VectorXd noisy = optimum(MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, noise));
  EXPECT_LT((clean - noisy).norm(), 1e-3 * clean.norm());
}

TEST(MakeObjectFactor, NoiseOfDepthWeakensTheRay) {
  FactorNoise noise = kNoNoise;
  noise.depth_sigma = 0.2;
  const PoseAndShape at = ExamplePose();
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), at, 0, noise);
  const Eigen::Matrix3d covariance = InformationOf(factor).inverse().block<3, 3>(3, 3);
  const Eigen::Vector3d weakest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(2);
  const Eigen::Vector3d ray =
      at.T_camera_object.linear().transpose() * at.T_camera_object.translation().normalized();
  EXPECT_GT(std::abs(weakest.dot(ray)), 0.999);
  EXPECT_NEAR(ray.dot(covariance * ray), std::pow(0.2 * at.T_camera_object.translation().norm(), 2), 0.02);
}

// One image leaves directions open: no edge matched, no information.
TEST(MakeObjectFactor, NoEvidenceIsNoInformation) {
  const Eigen::Index size = 6 + kModes;
  const ImageEvidence nothing{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  const ObjectFactor factor = MakeObjectFactor(nothing, ExamplePose(), 0, FactorNoise{});
  EXPECT_LT(factor.A.norm(), 1e-3);
  EXPECT_EQ(factor.b.norm(), 0);
}

// --- Turning the object's own axes

TEST(Turn, TheSameResidualForTheTurnedObject) {
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, FactorNoise{});
  const PoseAndShape seen = SeenElsewhere(ExamplePose());
  for (const double angle : {0.3, M_PI / 2, M_PI}) {
    ObjectFactor turned = factor;
    Turn(angle, turned);
    EXPECT_TRUE(Residual(turned, Turned(seen, angle)).isApprox(Residual(factor, seen), 1e-9)) << angle;
  }
}

TEST(Turn, IsWhatMakeObjectFactorDoesWithATurn) {
  const PoseAndShape at = ExamplePose(), seen = Turned(SeenElsewhere(at), M_PI);
  ObjectFactor turned = MakeObjectFactor(ExampleEvidence(), at, 0, FactorNoise{});
  Turn(M_PI, turned);
  const ObjectFactor made = MakeObjectFactor(ExampleEvidence(), at, M_PI, FactorNoise{});
  EXPECT_TRUE(InformationOf(made).isApprox(InformationOf(turned), 1e-6));
  EXPECT_NEAR(Residual(made, seen).squaredNorm(), Residual(turned, seen).squaredNorm(), 1e-6);
}

// --- Views that see the front at the back

TEST(MarginalizeRotation, LeavesTheMarginalOfTheRest) {
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, FactorNoise{});
  ObjectFactor forgetful = factor;
  MarginalizeRotation(forgetful);
  const Eigen::Index rest = 3 + kModes;
  const Eigen::MatrixXd marginal_covariance = InformationOf(factor).inverse().bottomRightCorner(rest, rest);
  const Eigen::MatrixXd H = InformationOf(forgetful);
  EXPECT_TRUE(H.bottomRightCorner(rest, rest).isApprox(marginal_covariance.inverse(), 1e-6));
  EXPECT_LT(H.topRows<3>().norm(), 1e-6 * H.norm());
}

TEST(MarginalizeRotation, KeepsTheOptimumOfTheRest) {
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, FactorNoise{});
  ObjectFactor forgetful = factor;
  MarginalizeRotation(forgetful);
  const Eigen::VectorXd optimum = -InformationOf(factor).ldlt().solve(GradientOf(factor));
  const Eigen::Index rest = 3 + kModes;
  const Eigen::VectorXd forgotten =
      -InformationOf(forgetful).bottomRightCorner(rest, rest).ldlt().solve(GradientOf(forgetful).tail(rest));
  EXPECT_TRUE(forgotten.isApprox(optimum.tail(rest), 1e-6));
}

TEST(MarginalizeRotation, TheResidualNoLongerFeelsATurnInPlace) {
  ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, FactorNoise{});
  MarginalizeRotation(factor);
  const PoseAndShape at = ExamplePose();
  EXPECT_LT((Residual(factor, Turned(at, 1.5)) - Residual(factor, at)).norm(), 1e-2);
}

// --- Cameras that may have drifted

TEST(WithDrift, NoDriftChangesNothing) {
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, FactorNoise{});
  const ObjectFactor same = WithDrift(factor, {});
  EXPECT_EQ(same.A, factor.A);
  EXPECT_EQ(same.b, factor.b);
}

TEST(WithDrift, AddsTheCamerasUncertaintyAtTheObjectsDistance) {
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, kNoNoise);
  const ObjectFactor drifted = WithDrift(factor, {0.3, 0.1});
  const Eigen::MatrixXd added = InformationOf(drifted).inverse() - InformationOf(factor).inverse();
  const double distance = ExamplePose().T_camera_object.translation().norm();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(added(i, i), 0.01, 1e-4);
    EXPECT_NEAR(added(3 + i, 3 + i), 0.09 + std::pow(0.1 * distance, 2), 1e-3);
    EXPECT_NEAR(added(6 + i, 6 + i), 0, 1e-4) << "a shape does not drift";
  }
}

TEST(WithDrift, ResidualsOnlyBecomeSmaller) {
  const ObjectFactor factor = MakeObjectFactor(ExampleEvidence(), ExamplePose(), 0, FactorNoise{});
  const PoseAndShape seen = SeenElsewhere(ExamplePose());
  double before = Residual(factor, seen).squaredNorm();
  for (const double sigma : {0.05, 0.2, 0.8}) {
    const double now = Residual(WithDrift(factor, {sigma, 0.1 * sigma}), seen).squaredNorm();
    EXPECT_LT(now, before) << sigma;
    before = now;
  }
}

}  // namespace
}  // namespace armature
