// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "retrieval/shape_distance.h"
#include "support/frame_library.h"

namespace armature {
namespace {

using testing::FrameInstances;
using testing::SomeCoefficients;

const Eigen::Vector3d kDeviations(0.2, 0.1, 0.05);

ShapeEvidence EvidenceAbout(const Eigen::VectorXd& mean, const Eigen::MatrixXd& information) {
  return {information, information * mean};
}

// Of full rank and not diagonal.
Eigen::Matrix3d FullInformation() { return Eigen::Matrix3d{{30, 8, -4}, {8, 12, 3}, {-4, 3, 5}}; }

// All instances by (x - m)^T C^-1 (x - m), of the modes that the mean and the covariance are of.
std::vector<Neighbour> ByMahalanobis(const CategoryInstances& instances, const Eigen::VectorXd& mean,
                                     const Eigen::MatrixXd& covariance) {
  std::vector<Neighbour> all;
  for (int i = 0; i < instances.size(); ++i) {
    const Eigen::VectorXd d = instances.coefficients.col(i).head(mean.size()).cast<double>() - mean;
    all.push_back({i, std::sqrt(d.dot(covariance.inverse() * d))});
  }
  std::sort(all.begin(), all.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.distance < b.distance; });
  return all;
}

void ExpectNear(const std::vector<Neighbour>& actual, const std::vector<Neighbour>& expected,
                double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (size_t i = 0; i < actual.size(); ++i) {
    EXPECT_EQ(actual[i].instance, expected[i].instance) << i;
    EXPECT_NEAR(actual[i].distance, expected[i].distance, tolerance * expected[i].distance) << i;
  }
}

// --- Features

TEST(Features, AreCoefficientsInDeviationsOrMetres) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(4));
  EXPECT_EQ(Features(instances, kDeviations, {}), instances.coefficients);
  const Eigen::MatrixXf raw = Features(instances, kDeviations, {.space = FeatureSpace::kRaw});
  EXPECT_TRUE(raw.isApprox(kDeviations.cast<float>().asDiagonal() * instances.coefficients));
}

// Metres: as far apart as the shape vectors are.
TEST(Features, RawDistancesAreThoseOfTheShapes) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(2));
  const Eigen::MatrixXf raw = Features(instances, kDeviations, {.space = FeatureSpace::kRaw});
  EXPECT_NEAR((raw.col(0) - raw.col(1)).norm(), (instances.edges.col(0) - instances.edges.col(1)).norm(),
              1e-5);
}

TEST(Features, OnlyTheFirstModes) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(4));
  EXPECT_EQ(Features(instances, kDeviations, {.modes = 2}), instances.coefficients.topRows(2));
  EXPECT_EQ(Features(instances, kDeviations, {.modes = 9}), instances.coefficients) << "there are only three";
}

TEST(Features, SizesAreMoreDimensions) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(4));
  const Eigen::MatrixXf whitened =
      Features(instances, kDeviations, {.modes = 1, .with_size = true, .size_sigma = 0.25});
  ASSERT_EQ(whitened.rows(), 4);
  EXPECT_EQ(whitened.row(0), instances.coefficients.row(0));
  EXPECT_TRUE(whitened.bottomRows(3).isApprox(4 * instances.sizes));
  const Eigen::MatrixXf raw =
      Features(instances, kDeviations, {.space = FeatureSpace::kRaw, .with_size = true, .size_sigma = 0.25});
  EXPECT_EQ(raw.bottomRows(3), instances.sizes) << "metres are metres";
}

TEST(Features, AQueryIsDescribedAsTheInstancesAre) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(3));
  const ShapeQuery query{
      instances.coefficients.col(1).cast<double>(), instances.sizes.col(1).cast<double>(), {}};
  for (const FeatureSpace space : {FeatureSpace::kWhitened, FeatureSpace::kRaw}) {
    const FeatureOptions options{.space = space, .modes = 2, .with_size = true};
    EXPECT_EQ(ComputeFeatures(query, kDeviations, options), Features(instances, kDeviations, options).col(1));
  }
}

// --- By the evidence's own metric

TEST(Likeliest, IsNearestByTheInverseCovariance) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(40));
  const Eigen::Vector3d mean(0.5, -0.8, 1.1);
  for (const double sigma : {0.0, 0.3, 2.0}) {
    const Eigen::Matrix3d covariance =
        FullInformation().inverse() + sigma * sigma * Eigen::Matrix3d::Identity();
    ExpectNear(Likeliest(instances, EvidenceAbout(mean, FullInformation()), sigma, 0, 40),
               ByMahalanobis(instances, mean, covariance), 1e-5);
  }
}

TEST(Likeliest, OfFewerModesIsTheMarginal) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(40));
  const Eigen::Vector3d mean(0.5, -0.8, 1.1);
  const Eigen::Matrix3d covariance = FullInformation().inverse() + 0.04 * Eigen::Matrix3d::Identity();
  for (const int modes : {1, 2}) {
    ExpectNear(Likeliest(instances, EvidenceAbout(mean, FullInformation()), 0.2, modes, 40),
               ByMahalanobis(instances, mean.head(modes), covariance.topLeftCorner(modes, modes)), 5e-3);
  }
}

TEST(Likeliest, WhatIsNotKnownDoesNotCount) {
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(3, 4);
  coefficients.row(0) << 0.1, 0, 0, 0.2;
  coefficients.row(1) << 0, 2, -2, 0;
  Eigen::Matrix3d information = Eigen::Vector3d(9, 0, 4).asDiagonal();
  const CategoryInstances instances = FrameInstances(coefficients);
  const ShapeEvidence evidence{information, Eigen::Vector3d(0, 0, 0)};
  const std::vector<Neighbour> found = Likeliest(instances, evidence, 0, 0, 4);
  const std::array<int, 4> expected{1, 2, 0, 3};  // equally likely ones as they are listed
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(found.at(i).instance, expected[i]);
  EXPECT_EQ(found[0].distance, found[1].distance);
  EXPECT_NEAR(found[3].distance, 0.6, 1e-6) << "standard deviations";
}

// As a solution leaves it that has not quite converged, rounded as it is written.
TEST(Likeliest, ATraceOfInformationIsNone) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(20));
  Eigen::Matrix3d information = Eigen::Vector3d(9, 0, 4).asDiagonal();
  const Eigen::Vector3d vector(4, 0, -2);
  const std::vector<Neighbour> expected = Likeliest(instances, {information, vector}, 0.1, 0, 20);
  information(1, 1) = 5e-6;
  information(0, 1) = information(1, 0) = -1e-6;
  ExpectNear(Likeliest(instances, {information, vector + Eigen::Vector3d(0, 0.02, 0)}, 0.1, 0, 20), expected,
             1e-2);
  information(1, 1) = -5e-6;
  ExpectNear(Likeliest(instances, {information, vector}, 0.1, 0, 20), expected, 1e-2);
}

TEST(Likeliest, NoInformationAtAllTakesTheFirst) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(5));
  const std::vector<Neighbour> found =
      Likeliest(instances, {Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()}, 0.1, 0, 2);
  EXPECT_EQ(found, (std::vector<Neighbour>{{0, 0}, {1, 0}}));
}

TEST(Likeliest, AsManyAsThereAre) {
  const CategoryInstances instances = FrameInstances(SomeCoefficients(5));
  const ShapeEvidence evidence = EvidenceAbout(Eigen::Vector3d::Zero(), FullInformation());
  EXPECT_EQ(Likeliest(instances, evidence, 0.1, 0, 3).size(), 3);
  EXPECT_EQ(Likeliest(instances, evidence, 0.1, 0, 1000).size(), 5);
  EXPECT_EQ(Likeliest(Without(instances, {0, 1, 2, 3, 4}), evidence, 0.1, 0, 3).size(), 0);
}

}  // namespace
}  // namespace armature
